//! What a simulation shows, and what it is continued from: arrays by name.

/// A named list of values, as many a particle or node as it has components.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// In small letters, words joined by `_`.
    pub name: &'static str,
    /// Values a particle or node: 1, 2 (a vector of a plane), 3, 4 or 9 (matrices, column by column), or more.
    pub components: usize,
    /// Its values.
    pub values: Values,
}

impl Array {
    /// An array of vectors.
    pub(crate) fn floats<const N: usize>(name: &'static str, values: impl IntoIterator<Item = [f32; N]>) -> Self {
        let mut values = values.into_iter();
        Self::floats_of(name, &mut || values.next())
    }

    /// The same, compiled once for all iterators. As `dyn` ones they would bring all the methods that iterators have.
    fn floats_of<const N: usize>(name: &'static str, next: &mut dyn FnMut() -> Option<[f32; N]>) -> Self {
        Self { name, components: N, values: Values::F32(std::iter::from_fn(next).flatten().collect()) }
    }

    /// An array of so many numbers a particle or node.
    pub(crate) fn numbers(name: &'static str, components: usize, values: impl Iterator<Item = f32>) -> Self {
        Self { name, components, values: Values::F32(values.collect()) }
    }

    /// An array of whole numbers.
    pub(crate) fn whole(name: &'static str, values: Vec<u32>) -> Self {
        Self { name, components: 1, values: Values::U32(values) }
    }

    fn fault(&self, wanted: usize) -> String {
        format!("array `{}` holds {} values of its kind, where {wanted} are wanted", self.name, self.values.len())
    }
}

/// The values of an [`Array`].
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Single precision.
    F32(Vec<f32>),
    /// Double precision.
    F64(Vec<f64>),
    /// Whole numbers.
    U32(Vec<u32>),
}

impl Values {
    /// How many values there are.
    pub fn len(&self) -> usize {
        match self {
            Self::F32(values) => values.len(),
            Self::F64(values) => values.len(),
            Self::U32(values) => values.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// All that the next step of a simulation depends on, in the order in which it lies in memory: a simulation of the same
/// scene in the same layout that is set to it goes on as the first would have.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Steps done.
    pub steps: u64,
    /// The members of the particles, and `identity`: which particle of the scene lies at each place.
    pub arrays: Vec<Array>,
}

impl State {
    fn array(&self, name: &str) -> Result<&Array, String> {
        self.arrays.iter().find(|array| array.name == name).ok_or_else(|| format!("array `{name}` is missing"))
    }

    /// The `count` vectors of an array.
    pub(crate) fn floats<const N: usize>(&self, name: &str, count: usize) -> Result<&[[f32; N]], String> {
        Ok(self.numbers(name, N, count)?.as_chunks().0)
    }

    /// The numbers of an array of `components` numbers for each of `count` particles.
    pub(crate) fn numbers(&self, name: &str, components: usize, count: usize) -> Result<&[f32], String> {
        let array = self.array(name)?;
        match &array.values {
            Values::F32(values) if values.len() == components * count => Ok(values),
            _ => Err(array.fault(components * count)),
        }
    }

    /// The numbers of double precision of an array of `components` numbers for each of `count` particles.
    pub(crate) fn doubles(&self, name: &str, components: usize, count: usize) -> Result<&[f64], String> {
        let array = self.array(name)?;
        match &array.values {
            Values::F64(values) if values.len() == components * count => Ok(values),
            _ => Err(array.fault(components * count)),
        }
    }

    /// The `count` whole numbers of an array.
    pub(crate) fn whole(&self, name: &str, count: usize) -> Result<&[u32], String> {
        let array = self.array(name)?;
        match &array.values {
            Values::U32(values) if values.len() == count => Ok(values),
            _ => Err(array.fault(count)),
        }
    }
}

/// Energies of the particles in J (in 2D, of a slab one metre thick), summed in `f64`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Of motion; the affine and higher parts of velocity are not counted.
    pub kinetic: f64,
    /// Stored by deformation.
    pub elastic: f64,
}
