"""The workloads of `allotrope compare taichi`, in Taichi. The program runs this file and talks to it in lines:

    build NAME          -> @ RESULT [RESULT]    of one call as written, and tuned by hand where there is something to tune
    time NAME VARIANT N -> @ MILLISECONDS       of a call, the mean of N; the variants are `written` and `tuned`

Inputs and sizes are those of `src/workloads`. `THREADS` gives the number of threads.
"""
import os
import sys
import time

import numpy as np
import taichi as ti


def ramp(shape):
    """Values that differ from cell to cell."""
    count = int(np.prod(shape))
    return ((np.arange(count, dtype=np.int64) * 7919 % 1009) / 1009.0).astype(np.float32).reshape(shape)


def mean(field):
    return float(field.to_numpy().astype(np.float64).mean())


def saxpy():
    x, y = ti.field(ti.f32, 1 << 24), ti.field(ti.f32, 1 << 24)
    x.from_numpy(ramp(1 << 24))

    @ti.kernel
    def run(a: ti.f32):
        for i in y:
            y[i] = a * x[i] + y[i]

    return lambda: run(0.5), None, lambda: mean(y)


def total():
    x = ti.field(ti.f32, 1 << 24)
    x.from_numpy(ramp(1 << 24))
    found = [0.0]

    @ti.kernel
    def run() -> ti.f32:
        s = 0.0
        for i in x:
            s += x[i]
        return s

    def call():
        found[0] = run()

    return call, None, lambda: found[0]


def jacobi():
    n = 2048
    u, v = ti.field(ti.f32, (n, n)), ti.field(ti.f32, (n, n))
    u.from_numpy(ramp((n, n)))

    @ti.kernel
    def written():
        for i, j in u:
            if 0 < i < n - 1 and 0 < j < n - 1:
                v[i, j] = 0.25 * (u[i - 1, j] + u[i + 1, j] + u[i, j - 1] + u[i, j + 1])

    @ti.kernel
    def tuned():
        for i in range(1, n - 1):
            for j in range(1, n - 1):
                v[i, j] = 0.25 * (u[i - 1, j] + u[i + 1, j] + u[i, j - 1] + u[i, j + 1])

    return written, tuned, lambda: mean(v)


def laplacian7():
    n = 192
    p, q = ti.field(ti.f32, (n, n, n)), ti.field(ti.f32, (n, n, n))
    p.from_numpy(ramp((n, n, n)))

    @ti.kernel
    def written():
        for i, j, k in p:
            if 0 < i < n - 1 and 0 < j < n - 1 and 0 < k < n - 1:
                q[i, j, k] = (p[i - 1, j, k] + p[i + 1, j, k] + p[i, j - 1, k] + p[i, j + 1, k]
                              + p[i, j, k - 1] + p[i, j, k + 1] - 6 * p[i, j, k])

    @ti.kernel
    def tuned():
        for i in range(1, n - 1):
            for j in range(1, n - 1):
                for k in range(1, n - 1):
                    q[i, j, k] = (p[i - 1, j, k] + p[i + 1, j, k] + p[i, j - 1, k] + p[i, j + 1, k]
                                  + p[i, j, k - 1] + p[i, j, k + 1] - 6 * p[i, j, k])

    return written, tuned, lambda: float((q.to_numpy().astype(np.float64) ** 2).mean())


def histogram():
    keys, counts = ti.field(ti.i32, 1 << 22), ti.field(ti.i32, 256)
    n = np.arange(1 << 22, dtype=np.uint64)
    keys.from_numpy(((n * 2654435761 & 0xFFFFFFFF) >> 24).astype(np.int32))

    @ti.kernel
    def written():
        for k in keys:
            counts[keys[k]] += 1

    @ti.kernel
    def tuned():
        ti.loop_config(serialize=True)
        for k in range(1 << 22):
            counts[keys[k]] = counts[keys[k]] + 1

    def centre():
        found = counts.to_numpy().astype(np.float64)
        return float((found * np.arange(256)).sum() / found.sum())

    return written, tuned, centre


def julia():
    height = 320
    counts = ti.field(ti.i32, (2 * height, height))

    @ti.kernel
    def written(im: ti.f32):
        for i, j in counts:
            x, y = 2.0 * (i / height - 1.0), 2.0 * (j / height - 0.5)
            count = 0
            while ti.sqrt(x * x + y * y) < 20.0 and count < 50:
                x, y = x * x - y * y - 0.8, 2.0 * x * y + im
                count += 1
            counts[i, j] = count

    @ti.kernel
    def tuned(im: ti.f32):
        for i, j in counts:
            x, y = 2.0 * (i / height - 1.0), 2.0 * (j / height - 0.5)
            count = 0
            while x * x + y * y < 400.0 and count < 50:
                x, y = x * x - y * y - 0.8, 2.0 * x * y + im
                count += 1
            counts[i, j] = count

    return lambda: written(0.19), lambda: tuned(0.19), lambda: mean(counts)


def nbody():
    count = 4096
    x, a = ti.Vector.field(3, ti.f32, count), ti.Vector.field(3, ti.f32, count)
    n = np.arange(count)
    x.from_numpy((np.stack([n * 37 % count, n * 91 % count, n], axis=1) / count).astype(np.float32))

    @ti.kernel
    def written():
        for i in x:
            here, total = x[i], ti.Vector([0.0, 0.0, 0.0])
            for j in range(count):
                arm = x[j] - here
                inverse = 1.0 / ti.sqrt(arm.dot(arm) + 1e-4)
                total += arm * (inverse * inverse * inverse)
            a[i] = total

    @ti.kernel
    def tuned():
        for i in x:
            here, total = x[i], ti.Vector([0.0, 0.0, 0.0])
            for j in range(count):
                arm = x[j] - here
                inverse = ti.rsqrt(arm.dot(arm) + 1e-4)
                total += arm * (inverse * inverse * inverse)
            a[i] = total

    def size():
        found = a.to_numpy().astype(np.float64)
        return float(np.sqrt((found**2).sum(axis=1)).mean())

    return written, tuned, size


def mpm88(particles, nodes):
    """MLS-MPM of a weakly compressible fluid, interleaved records, particles as they are drawn; tuned: the scatter in a
    serial loop of plain adds."""
    dx, gravity, wall, stiffness = 1.0 / nodes, 9.8, 3, 400.0
    dt, volume = 2e-4 * 128 / nodes, 0.25 * dx * dx
    x, v = ti.Vector.field(2, ti.f32), ti.Vector.field(2, ti.f32)
    c, j = ti.Matrix.field(2, 2, ti.f32), ti.field(ti.f32)
    grid_v, grid_m = ti.Vector.field(2, ti.f32), ti.field(ti.f32)
    ti.root.dense(ti.i, particles).place(x, v, c, j)
    ti.root.dense(ti.ij, nodes).place(grid_v, grid_m)

    @ti.func
    def stencil(at):
        scaled = at / dx
        base = ti.cast(scaled - 0.5, ti.i32)
        fx = scaled - base
        return base, fx, ti.Matrix.rows([0.5 * (1.5 - fx) ** 2, 0.75 - (fx - 1.0) ** 2, 0.5 * (fx - 0.5) ** 2])

    @ti.kernel
    def clear():
        for node in ti.grouped(grid_m):
            grid_v[node] = ti.Vector([0.0, 0.0])
            grid_m[node] = 0.0

    @ti.func
    def moved(p):
        """Where a particle scatters, and its momentum as an affine function of the place."""
        base, fx, w = stencil(x[p])
        stress = -4.0 * dt * stiffness * volume * (j[p] - 1.0) / (dx * dx)
        return base, fx, w, stress * ti.Matrix.identity(ti.f32, 2) + volume * c[p]

    @ti.kernel
    def scatter():
        for p in x:
            base, fx, w, affine = moved(p)
            for a, b in ti.static(ti.ndrange(3, 3)):
                offset = ti.Vector([a, b])
                weight = w[a, 0] * w[b, 1]
                grid_v[base + offset] += weight * (volume * v[p] + affine @ ((offset - fx) * dx))
                grid_m[base + offset] += weight * volume

    @ti.kernel
    def scatter_serial():
        ti.loop_config(serialize=True)
        for p in x:
            base, fx, w, affine = moved(p)
            for a, b in ti.static(ti.ndrange(3, 3)):
                offset = ti.Vector([a, b])
                weight, node = w[a, 0] * w[b, 1], base + offset
                grid_v[node] = grid_v[node] + weight * (volume * v[p] + affine @ ((offset - fx) * dx))
                grid_m[node] = grid_m[node] + weight * volume

    @ti.kernel
    def update():
        for node in ti.grouped(grid_m):
            velocity = grid_v[node]
            if grid_m[node] > 0.0:
                velocity /= grid_m[node]
            velocity[1] -= dt * gravity
            for k in ti.static(range(2)):
                if (node[k] < wall and velocity[k] < 0.0) or (node[k] > nodes - wall and velocity[k] > 0.0):
                    velocity[k] = 0.0
            grid_v[node] = velocity

    @ti.kernel
    def gather():
        for p in x:
            base, fx, w = stencil(x[p])
            velocity, gradient = ti.Vector([0.0, 0.0]), ti.Matrix([[0.0, 0.0], [0.0, 0.0]])
            for a, b in ti.static(ti.ndrange(3, 3)):
                offset = ti.Vector([a, b])
                weighted = w[a, 0] * w[b, 1] * grid_v[base + offset]
                velocity += weighted
                gradient += 4.0 / dx * weighted.outer_product(offset - fx)
            v[p] = velocity
            c[p] = gradient
            x[p] += dt * velocity
            j[p] *= 1.0 + dt * gradient.trace()

    @ti.kernel
    def start():
        for p in x:
            x[p] = 0.2 + 0.4 * ti.Vector([ti.random(), ti.random()])
            v[p] = ti.Vector([0.0, -1.0])
            c[p] = ti.Matrix([[0.0, 0.0], [0.0, 0.0]])
            j[p] = 1.0

    def step(scatter):
        clear()
        scatter()
        update()
        gather()

    start()
    falling = lambda: float(v.to_numpy().astype(np.float64)[:, 1].mean())
    return lambda: step(scatter), lambda: step(scatter_serial), falling, start


def shell():
    """u and w of the cells within three of a sphere of 200 in 512^3."""
    u, w = ti.field(ti.f32), ti.field(ti.f32)
    ti.root.pointer(ti.ijk, 64).bitmasked(ti.ijk, 8).place(u, w)

    @ti.kernel
    def activate():
        for i, j, k in ti.ndrange((50, 462), (50, 462), (50, 462)):
            distance = ti.sqrt((i - 256.0) ** 2 + (j - 256.0) ** 2 + (k - 256.0) ** 2) - 200
            if ti.abs(distance) < 3.0:
                u[i, j, k] = distance

    activate()
    return u, w


def mean_square(field):
    @ti.kernel
    def run() -> ti.f64:
        s = ti.cast(0.0, ti.f64)
        n = ti.cast(0.0, ti.f64)
        for at in ti.grouped(field):
            s += ti.cast(field[at], ti.f64) ** 2
            n += 1.0
        return s / n

    return run


def sparse_laplacian():
    u, w = shell()

    @ti.kernel
    def run():
        for i, j, k in u:
            w[i, j, k] = (u[i - 1, j, k] + u[i + 1, j, k] + u[i, j - 1, k] + u[i, j + 1, k] + u[i, j, k - 1]
                          + u[i, j, k + 1] - 6 * u[i, j, k])

    return run, None, mean_square(w)


def sparse_scale():
    u, _ = shell()

    @ti.kernel
    def run():
        for at in ti.grouped(u):
            u[at] *= 1.0001

    return run, None, mean_square(u)


def launch():
    one = ti.field(ti.f32, ())

    @ti.kernel
    def written():
        for _ in range(1):
            one[None] = 1.0

    @ti.kernel
    def tuned():
        one[None] = 1.0

    return written, tuned, lambda: float(one[None])


WORKLOADS = {
    "saxpy": saxpy,
    "sum": total,
    "jacobi": jacobi,
    "laplacian7": laplacian7,
    "histogram": histogram,
    "julia": julia,
    "nbody": nbody,
    "mpm88-8k": lambda: mpm88(8192, 128),
    "mpm88-1m": lambda: mpm88(1 << 20, 1024),
    "sparse-laplacian": sparse_laplacian,
    "sparse-scale": sparse_scale,
    "launch": launch,
}


def start_anew():
    """Frees the fields of the workload before."""
    ti.init(arch=ti.cpu, cpu_max_num_threads=int(os.environ["THREADS"]), log_level=ti.ERROR, offline_cache=False,
            fast_math=True)


def build(name):
    start_anew()
    written, tuned, result, *again = WORKLOADS[name]()
    results = []
    for call in [written, tuned]:
        if call is not None:
            for restart in again:
                restart()
            call()
            results.append(repr(result()))
    return {"written": written, "tuned": tuned}, results


def main():
    built = {}
    for line in sys.stdin:
        command, name, *more = line.split()
        if command == "build":
            built, answer = build(name)
        else:
            call, count = built[more[0]], int(more[1])
            start = time.perf_counter()
            for _ in range(count):
                call()
            ti.sync()
            answer = [repr((time.perf_counter() - start) / count * 1e3)]
        print("@", *answer, flush=True)


main()
