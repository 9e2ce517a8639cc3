//! What kernels expand to.

use super::expansion;

#[test]
fn light_loop() {
    insta::assert_snapshot!(expansion(
        "fn saxpy(y: &mut Field<f32, _>, x: &Field<f32, Soa>, a: f32) { for p in y { y[p] += a * x[p]; } }"
    ), @r#"
#[allow(unused_parens, clippy::deref_addrof, clippy::type_complexity)]
fn saxpy(
    y: &mut Field<f32, impl ::allotrope::Layout<::allotrope::I>>,
    x: &Field<f32, Soa>,
    a: f32,
) {
    {
        use ::allotrope::__private::{Hold as _, Lend as _};
        use ::allotrope::__private::Space as _;
        let __field_y = ::allotrope::__private::exclusive(
            &mut *y,
            &::allotrope::__private::Site {
                kernel: "saxpy",
                field: "y",
            },
        );
        let __field_x = ::allotrope::__private::shared(
            &*x,
            &::allotrope::__private::Site {
                kernel: "saxpy",
                field: "x",
            },
        );
        let __field_x_still = ::allotrope::__private::still(&*x);
        let __space = ::allotrope::__private::over(__field_y);
        let __fits = __space.fits(__field_x, [0], [0]);
        ::allotrope::__private::assert_shared(&a);
        ::allotrope::__private::launch(
            &__space,
            ::allotrope::__private::Options {
                kernel: "saxpy",
                number: 0usize,
                fits: __fits,
                heavy: false,
                scatter: ::core::option::Option::None,
                targets: &[],
                still: [__field_x_still.memory(), &[], &[], &[]],
                together: ::core::option::Option::None,
                ordered: false,
            },
            #[inline(always)]
            |__task| {
                let __field_y_paths = __field_y.paths();
                let __field_y = __field_y.of_job(&__field_y_paths);
                let __field_x_paths = __field_x.paths();
                let __field_x = __field_x
                    .of_task(&__field_x_paths, &__task, 0usize, &__field_x_still);
                let __held_a = ::allotrope::__private::Wrap(&a).hold();
                let y = ::allotrope::__private::NotAnAccess;
                let x = ::allotrope::__private::NotAnAccess;
                let _ = (&y, &x);
                __task
                    .rows(
                        #[inline(always)]
                        |__run| {
                            let __copy0 = ::allotrope::__private::buffer();
                            let __v0_x = __field_x
                                .row(
                                    &__run,
                                    ::allotrope::__private::Whole,
                                    [0],
                                    ::allotrope::__private::Other,
                                    &__copy0,
                                );
                            let __buffer1 = ::allotrope::__private::buffer();
                            let __v1_y = __field_y
                                .held(
                                    &__run,
                                    ::allotrope::__private::Whole,
                                    &__buffer1,
                                    ::allotrope::__private::OfLoop,
                                );
                            __run
                                .each_or_all(
                                    [],
                                    __v0_x.is_float() && __v1_y.is_float(),
                                    #[inline(always)]
                                    |__cell| {
                                        let p = __cell.index();
                                        let _ = (&p,);
                                        {
                                            {
                                                let __value = (*__held_a.get())
                                                    * (*(&(__v0_x).get(&__cell)));
                                                let mut __target = (__v1_y).get(&__cell);
                                                __target += __value;
                                                (__v1_y).set(&__cell, __target);
                                            };
                                        }
                                    },
                                );
                            __v1_y.flush(&__run);
                        },
                    );
            },
        );
    }
}
"#);
}

#[test]
fn stencil_with_a_reduction() {
    insta::assert_snapshot!(expansion(
        "fn smooth(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>) -> f32 {
            let mut change = 0.0;
            for (i, j) in v.interior(1) {
                if skip(i) { continue; }
                v[(i, j)] = 0.5 * (u[(i - 1, j)] + u[(i, j + 1)]);
                change.max_assign(v[(i, j)]);
            }
            change
        }"
    ), @r#"
#[allow(unused_parens, clippy::deref_addrof, clippy::type_complexity)]
fn smooth(
    u: &Field<f32, impl ::allotrope::Layout<Ij>, Ij>,
    v: &mut Field<f32, impl ::allotrope::Layout<Ij>, Ij>,
) -> f32 {
    let mut change = 0.0;
    {
        use ::allotrope::__private::Space as _;
        let __field_u = ::allotrope::__private::shared(
            &*u,
            &::allotrope::__private::Site {
                kernel: "smooth",
                field: "u",
            },
        );
        let __field_u_still = ::allotrope::__private::still(&*u);
        let __field_v = ::allotrope::__private::exclusive(
            &mut *v,
            &::allotrope::__private::Site {
                kernel: "smooth",
                field: "v",
            },
        );
        let __space = ::allotrope::__private::interior(__field_v, 1);
        let __fits = __space.fits(__field_u, [-1, 0], [0, 1]);
        let __r0 = &mut change;
        let __t0 = ::allotrope::__private::reduction(
            ::allotrope::__private::Max,
            &*__r0,
        );
        let __outs = ::allotrope::__private::launch(
            &__space,
            ::allotrope::__private::Options {
                kernel: "smooth",
                number: 0usize,
                fits: __fits,
                heavy: false,
                scatter: ::core::option::Option::None,
                targets: &[],
                still: [__field_u_still.memory(), &[], &[], &[]],
                together: ::core::option::Option::None,
                ordered: false,
            },
            #[inline(always)]
            |__task| {
                let __field_u_paths = __field_u.paths();
                let __field_u = __field_u
                    .of_task(&__field_u_paths, &__task, 0usize, &__field_u_still);
                let __field_v_paths = __field_v.paths();
                let __field_v = __field_v.of_job(&__field_v_paths);
                let u = ::allotrope::__private::NotAnAccess;
                let v = ::allotrope::__private::NotAnAccess;
                let _ = (&u, &v);
                let mut __p0 = __t0.partial();
                __task
                    .rows(
                        #[inline(always)]
                        |__run| {
                            let __copy0 = ::allotrope::__private::buffer();
                            let __v0_u = __field_u
                                .row(
                                    &__run,
                                    ::allotrope::__private::Whole,
                                    [-1, 0],
                                    ::allotrope::__private::Other,
                                    &__copy0,
                                );
                            let __copy1 = ::allotrope::__private::buffer();
                            let __v1_u = __field_u
                                .row(
                                    &__run,
                                    ::allotrope::__private::Whole,
                                    [0, 1],
                                    ::allotrope::__private::Other,
                                    &__copy1,
                                );
                            let __buffer2 = ::allotrope::__private::buffer();
                            let __v2_v = __field_v
                                .held(
                                    &__run,
                                    ::allotrope::__private::Whole,
                                    &__buffer2,
                                    ::allotrope::__private::OfLoop,
                                );
                            __run
                                .strips(
                                    #[inline(always)]
                                    |__run| {
                                        let mut __s0 = __t0.strip();
                                        __run
                                            .each(
                                                [1, 1],
                                                #[inline(always)]
                                                |__cell| {
                                                    let (i, j) = __cell.tuple();
                                                    let _ = (&i, &j);
                                                    let mut __e0 = __t0.identity();
                                                    '__element: {
                                                        if skip(i) {
                                                            break '__element;
                                                        }
                                                        (__v2_v)
                                                            .set(
                                                                &__cell,
                                                                0.5
                                                                    * ((*(&(__v0_u).get(&__cell)))
                                                                        + (*(&(__v1_u).get(&__cell)))),
                                                            );
                                                        __t0.apply(&mut __e0, (*(&(__v2_v).get(&__cell))));
                                                    }
                                                    __s0.put(&__cell, __e0);
                                                },
                                            );
                                        __p0.absorb(&__s0, &__run);
                                    },
                                );
                            __v2_v.flush(&__run);
                        },
                    );
                __p0.total()
            },
        );
        for __out in __outs {
            __t0.combine(__r0, __out);
        }
    }
    change
}
"#);
}

#[test]
fn unrolled_scatter() {
    insta::assert_snapshot!(expansion(
        "fn scatter(points: &Field<Point, _>, grid: &mut Field<Node, _, Ij>, mpm: &Mpm) {
            for p in points {
                let base = (points.x[p] * mpm.scale).as_ivec2();
                for (i, j) in unroll!(0..2, 0..1) {
                    let offset = ivec2(i, j);
                    grid.m[base + offset] += points.m[p];
                }
            }
        }"
    ), @r#"
#[allow(unused_parens, clippy::deref_addrof, clippy::type_complexity)]
fn scatter(
    points: &Field<Point, impl ::allotrope::Layout<::allotrope::I>>,
    grid: &mut Field<Node, impl ::allotrope::Layout<Ij>, Ij>,
    mpm: &Mpm,
) {
    {
        use ::allotrope::__private::{Hold as _, Lend as _};
        let __field_points = ::allotrope::__private::shared(
            &*points,
            &::allotrope::__private::Site {
                kernel: "scatter",
                field: "points",
            },
        );
        let __field_points_still = ::allotrope::__private::still(&*points);
        let __field_grid = ::allotrope::__private::exclusive(
            &mut *grid,
            &::allotrope::__private::Site {
                kernel: "scatter",
                field: "grid",
            },
        );
        let __space = ::allotrope::__private::over(__field_points);
        let __fits = true;
        ::allotrope::__private::assert_shared(&mpm);
        ::allotrope::__private::launch_inside_keyed(
            &__space,
            ::allotrope::__private::Options {
                kernel: "scatter",
                number: 0usize,
                fits: __fits,
                heavy: true,
                scatter: ::core::option::Option::None,
                targets: &[
                    &__field_grid
                        .target(
                            0usize,
                            &[
                                (
                                    __field_grid.member(__field_grid.tags().m),
                                    ::allotrope::__private::Op::Add,
                                ),
                            ],
                        ),
                ],
                still: [__field_points_still.memory(), &[], &[], &[]],
                together: ::core::option::Option::None,
                ordered: false,
            },
            ::allotrope::__private::key(
                &__space,
                0usize,
                [0, 0],
                [1, 0],
                true,
                &|__task, __sink| {
                    let __field_points_paths = __field_points.paths();
                    let __field_points = __field_points
                        .of_task(
                            &__field_points_paths,
                            &__task,
                            0usize,
                            &__field_points_still,
                        );
                    let __field_grid_paths = __field_grid.paths();
                    let __field_grid = __field_grid.of_job(&__field_grid_paths);
                    let __held_mpm = ::allotrope::__private::Wrap(mpm).hold();
                    let points = ::allotrope::__private::NotAnAccess;
                    let grid = ::allotrope::__private::NotAnAccess;
                    let _ = (&points, &grid);
                    __task
                        .runs(
                            #[inline(always)]
                            |__run| {
                                let __copy0 = ::allotrope::__private::buffer();
                                let __v0_points_x = __field_points
                                    .row(
                                        &__run,
                                        __field_points.tags().x,
                                        [0],
                                        ::allotrope::__private::OfLoop,
                                        &__copy0,
                                    );
                                __run
                                    .each(
                                        [],
                                        #[inline(always)]
                                        |__cell| {
                                            let p = __cell.index();
                                            let _ = (&p,);
                                            let __h0 = __v0_points_x.get(&__cell);
                                            __sink
                                                .put(
                                                    &__cell,
                                                    '__element: {
                                                        let base = ((*(&__h0)) * (__held_mpm.get()).scale)
                                                            .as_ivec2();
                                                        let _ = (&base,);
                                                        ::core::option::Option::Some(__field_grid.key(base))
                                                    },
                                                );
                                        },
                                    );
                            },
                        );
                },
            ),
            #[inline(always)]
            |__task| {
                let __field_points_paths = __field_points.paths();
                let __field_points = __field_points
                    .of_task(
                        &__field_points_paths,
                        &__task,
                        0usize,
                        &__field_points_still,
                    );
                let __field_grid_paths = __field_grid.paths();
                let __field_grid = __field_grid.of_job(&__field_grid_paths);
                let __held_mpm = ::allotrope::__private::Wrap(mpm).hold();
                let points = ::allotrope::__private::NotAnAccess;
                let grid = ::allotrope::__private::NotAnAccess;
                let _ = (&points, &grid);
                let __v2_grid_m = __field_grid
                    .accumulate(&__task, 0usize, __field_grid.tags().m);
                let __v2_grid_m_far = __v2_grid_m.far();
                let __target0 = __field_grid.of_target(&__task, 0usize);
                let __corners1_0 = __target0.corners();
                __task
                    .runs(
                        #[inline(always)]
                        |__run| {
                            let __copy0 = ::allotrope::__private::buffer();
                            let __v0_points_x = __field_points
                                .row(
                                    &__run,
                                    __field_points.tags().x,
                                    [0],
                                    ::allotrope::__private::OfLoop,
                                    &__copy0,
                                );
                            let __copy1 = ::allotrope::__private::buffer();
                            let __v1_points_m = __field_points
                                .row(
                                    &__run,
                                    __field_points.tags().m,
                                    [0],
                                    ::allotrope::__private::OfLoop,
                                    &__copy1,
                                );
                            __run
                                .each_of_pieces(
                                    [],
                                    #[inline(always)]
                                    |__cell| {
                                        let p = __cell.index();
                                        let _ = (&p,);
                                        let __h0 = __v0_points_x.get(&__cell);
                                        let __h1 = __v1_points_m.get(&__cell);
                                        {
                                            let base = ((*(&__h0)) * (__held_mpm.get()).scale)
                                                .as_ivec2();
                                            match (
                                                __target0
                                                    .based::<true, _>(&__corners1_0, base, [0, 0], [1, 0]),
                                            ) {
                                                (::core::option::Option::Some(__b1_0),) => {
                                                    {
                                                        #[allow(unused_variables)]
                                                        let (i, j) = (0i32, 0i32);
                                                        let offset = ivec2(i, j);
                                                        (__v2_grid_m).add_at(&__b1_0, offset, (*(&__h1)));
                                                    }
                                                    {
                                                        #[allow(unused_variables)]
                                                        let (i, j) = (1i32, 0i32);
                                                        let offset = ivec2(i, j);
                                                        (__v2_grid_m).add_at(&__b1_0, offset, (*(&__h1)));
                                                    }
                                                }
                                                _ => {
                                                    ::allotrope::__private::cold();
                                                    {
                                                        for i in 0i32..2i32 {
                                                            for j in 0i32..1i32 {
                                                                {
                                                                    let offset = ivec2(i, j);
                                                                    (__v2_grid_m_far).add(base + offset, (*(&__h1)));
                                                                }
                                                            }
                                                        }
                                                    }
                                                }
                                            }
                                        }
                                    },
                                );
                        },
                    );
            },
        );
    }
}
"#);
}

#[test]
fn top_level_and_serial_loops() {
    insta::assert_snapshot!(expansion(
        "fn host(u: &mut Field<Node, _, Ij>) -> f32 {
            u.v[(0, 0)].y = 2.0;
            u.m[(0, 0)] += u.m[(0, 1)];
            u[(0, 1)] = u[(1, 1)];
            #[serial]
            for (i, j) in u.interior(1) {
                u.m[(i, j)].min_assign(1.0);
            }
            u.m[(0, 0)]
        }"
    ), @r#"
#[allow(unused_parens, clippy::deref_addrof, clippy::type_complexity)]
fn host(u: &mut Field<Node, impl ::allotrope::Layout<Ij>, Ij>) -> f32 {
    {
        let __value = 2.0;
        let (__path, __at) = (
            ::allotrope::__private::tags(&*u).v,
            ::allotrope::__private::locate(&*u, (0, 0)),
        );
        let mut __target = ::allotrope::__private::read_at(&*u, __path, __at);
        __target.y = __value;
        ::allotrope::__private::write_at(&mut *u, __path, __at, __target);
    };
    {
        let __value = (*(&::allotrope::__private::read(
            &*u,
            ::allotrope::__private::tags(&*u).m,
            (0, 1),
        )));
        let (__path, __at) = (
            ::allotrope::__private::tags(&*u).m,
            ::allotrope::__private::locate(&*u, (0, 0)),
        );
        let mut __target = ::allotrope::__private::read_at(&*u, __path, __at);
        __target += __value;
        ::allotrope::__private::write_at(&mut *u, __path, __at, __target);
    };
    {
        let __value = (*(&::allotrope::__private::read(
            &*u,
            ::allotrope::__private::Whole,
            (1, 1),
        )));
        let (__path, __at) = (::allotrope::__private::Whole, (0, 1));
        ::allotrope::__private::write(&mut *u, __path, __at, __value)
    };
    for (i, j) in ::allotrope::__private::interior_tuples(&*u, 1) {
        {
            let __value = 1.0;
            let (__path, __at) = (
                ::allotrope::__private::tags(&*u).m,
                ::allotrope::__private::locate(&*u, (i, j)),
            );
            let mut __target = ::allotrope::__private::read_at(&*u, __path, __at);
            __target = ::allotrope::__private::min(__target, __value);
            ::allotrope::__private::write_at(&mut *u, __path, __at, __target);
        };
    }
    (*(&::allotrope::__private::read(&*u, ::allotrope::__private::tags(&*u).m, (0, 0))))
}
"#);
}

#[test]
fn errors_leave_a_function_of_the_same_type() {
    insta::assert_snapshot!(expansion(
        "/// Docs.
        pub fn wrong(mut u: &mut Field<f32, _>, by: f32) -> f32 { for p in u { break; } by }"
    ), @r#"
::core::compile_error! {
    "`break` cannot leave a parallel loop [A0116]\n= note: other threads are at other elements at that time\n= help: `continue` skips the rest of the element; to search, accumulate into a variable (`found.max_assign(..)`); or write `#[serial]` before the loop"
}
#[allow(unused, missing_docs, clippy::all)]
pub fn wrong(
    u: &mut Field<f32, impl ::allotrope::Layout<::allotrope::I>>,
    by: f32,
) -> f32 {
    loop {}
}
"#);
}

#[test]
fn races_leave_the_kernel_on_one_thread() {
    insta::assert_snapshot!(expansion(
        "/// Docs.
        pub fn wrong(u: &mut Field<f32, _>, by: f32) -> f32 { for p in u { u[p + 1] = by; } by }"
    ), @r#"
::core::compile_error! {
    "`u[p + 1]` is written in a parallel loop, at an index that is not the iteration's own [A0202]\n= note: it is the own element of another iteration; the own index is `p`\n= help: write at the own index, and move the indices that are read instead"
}
#[allow(warnings)]
/// Docs.
#[allow(unused_parens, clippy::deref_addrof, clippy::type_complexity)]
pub fn wrong(
    u: &mut Field<f32, impl ::allotrope::Layout<::allotrope::I>>,
    by: f32,
) -> f32 {
    for p in ::allotrope::__private::indices(&*u) {
        {
            let __value = by;
            let (__path, __at) = (::allotrope::__private::Whole, p + 1);
            ::allotrope::__private::write(&mut *u, __path, __at, __value)
        };
    }
    by
}
"#);
}

#[test]
fn attributes_stay_on_statements() {
    insta::assert_snapshot!(expansion(
        "fn checked(u: &mut Field<f32, _>) {
            #[allow(unused)]
            for p in u {
                #[cfg(debug_assertions)]
                u[p] = 1.0;
                #[cfg(debug_assertions)]
                println!(\"{}\", u[p]);
                #[cfg(any())]
                u[p] *= 2.0;
            }
            #[cfg(any())]
            u.fill(0.0);
        }"
    ), @r#"
#[allow(unused_parens, clippy::deref_addrof, clippy::type_complexity)]
fn checked(u: &mut Field<f32, impl ::allotrope::Layout<::allotrope::I>>) {
    {
        #[allow(unused)]
        {
            let __field_u = ::allotrope::__private::exclusive(
                &mut *u,
                &::allotrope::__private::Site {
                    kernel: "checked",
                    field: "u",
                },
            );
            let __space = ::allotrope::__private::over(__field_u);
            let __fits = true;
            ::allotrope::__private::launch_own(
                &__space,
                ::allotrope::__private::Options {
                    kernel: "checked",
                    number: 0usize,
                    fits: __fits,
                    heavy: false,
                    scatter: ::core::option::Option::None,
                    targets: &[],
                    still: [&[], &[], &[], &[]],
                    together: ::core::option::Option::None,
                    ordered: false,
                },
                #[inline(always)]
                |__task| {
                    let __field_u_paths = __field_u.paths();
                    let __field_u = __field_u.of_job(&__field_u_paths);
                    let u = ::allotrope::__private::NotAnAccess;
                    let _ = (&u,);
                    __task
                        .rows(
                            #[inline(always)]
                            |__run| {
                                let __v0_u = __field_u
                                    .own(
                                        &__run,
                                        ::allotrope::__private::Whole,
                                        ::allotrope::__private::OfLoop,
                                    );
                                __run
                                    .each(
                                        [],
                                        #[inline(always)]
                                        |__cell| {
                                            let p = __cell.index();
                                            let _ = (&p,);
                                            {
                                                #[cfg(debug_assertions)] (__v0_u).set(&__cell, 1.0);
                                                #[cfg(debug_assertions)]
                                                println!("{}", (* (& (__v0_u).get(& __cell))));
                                                #[cfg(any())]
                                                {
                                                    let __value = 2.0;
                                                    let mut __target = (__v0_u).get(&__cell);
                                                    __target *= __value;
                                                    (__v0_u).set(&__cell, __target);
                                                };
                                            }
                                        },
                                    );
                            },
                        );
                },
            );
        };
    }
    #[cfg(any())] u.fill(0.0);
}
"#);
}

/// Whether a kernel's loop over `p` can be sorted by where it accumulates.
fn has_key(body: &str) -> bool {
    let kernel = "fn k(p: &mut Field<P, _>, g: &mut Field<f32, _, Ij>, q: &Field<i32, _>, m: &M, n: i32)";
    expansion(&format!("{kernel} {{ {body} }}")).contains("_keyed")
}

#[test]
fn keys_are_found_where_they_do_nothing_but_compute() {
    for body in [
        "for a in p { g[p.x[a].as_ivec2()] += 1.0; }",
        "for a in p { let b = ivec2(q[a], n); g[b] += 1.0; }",
        "for a in p { if p.dead[a] { continue; } let b = p.x[a].as_ivec2(); p.x[a] *= 2.0; g[b + ivec2(0, 1)] += m.w; }",
        "for a in p { let b = p.x[a].as_ivec2(); if m.on { for (i, j) in unroll!(0..2, 0..2) { g[b + ivec2(i, j)] += 1.0; } } }",
        "for ij in g { g[ij + ivec2(1, 0)] += 1.0; }",
        "#[scatter(Colored)] for a in p { g[m.cell(p.x[a])] += 1.0; }",
        "#[scatter(Colored, key = m.cell(p.x[a]))] for a in p { for b in 0..n { let c = f(b); g[c] += 1.0; } }",
    ] {
        assert!(has_key(body), "{body}");
    }
    for body in [
        // What is called twice might be seen to be.
        "for a in p { g[m.cell(p.x[a])] += 1.0; }",
        "for a in p { let b = m.counter.fetch_add(1, Relaxed); g[(b, b)] += 1.0; }",
        "for a in p { let b = random::<i32>() % n; g[(b, b)] += 1.0; }",
        // What follows tells the type.
        "for a in p { let b = 1 << q[a]; g[(b, 0)] += 1.0; f(b); }",
        "for a in p { let b = 7; g[(b, b)] += 1.0; f(b); }",
        // Not at the top of the body, or not known before the loop runs.
        "for a in p { for b in 0..n { g[(b, b)] += 1.0; } }",
        "for a in p { let mut b = ivec2(0, 0); b.x = q[a]; g[b] += 1.0; }",
        "for a in p { if m.on { g[(q[a], q[a])] += 1.0; } }",
        "for a in p { let b = if m.on { continue; } else { ivec2(0, q[a]) }; g[b] += 1.0; }",
        "for a in p { if m.on { continue; } else { f(); } let b = ivec2(0, q[a]); g[b] += 1.0; }",
        // Another schedule.
        "#[scatter(Private)] for a in p { g[p.x[a].as_ivec2()] += 1.0; }",
    ] {
        assert!(!has_key(body), "{body}");
    }
}
