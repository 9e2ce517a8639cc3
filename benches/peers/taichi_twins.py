"""The workloads of `cargo bench --bench ratios`, in Taichi, on one thread: out of the caches, and in them.

    python -m venv V && V/bin/pip install taichi==1.7.4 numpy
    V/bin/python benches/peers/taichi_twins.py
"""
import math
import time

import numpy as np
import taichi as ti

ti.init(arch=ti.cpu, cpu_max_num_threads=1, log_level=ti.ERROR, offline_cache=False, fast_math=True)


def bench(name, kernel, repeats):
    """The median of 15 means over `repeats` calls, after a warm-up."""
    kernel()
    kernel()
    times = []
    for _ in range(15):
        start = time.perf_counter()
        for _ in range(repeats):
            kernel()
        times.append((time.perf_counter() - start) / repeats)
    print(f"{name:32s} {sorted(times)[7] * 1e3:10.4f} ms", flush=True)


def total(n):
    a = ti.field(ti.f32, n)
    a.fill(0.5)

    @ti.kernel
    def run() -> ti.f32:
        s = 0.0
        for i in a:
            s += a[i]
        return s

    bench(f"sum 2^{int(math.log2(n))}", run, max(1, (1 << 24) // n))


def jacobi(n):
    u, v = ti.field(ti.f32, (n, n)), ti.field(ti.f32, (n, n))

    @ti.kernel
    def run():
        for i, j in u:
            if 0 < i < n - 1 and 0 < j < n - 1:
                v[i, j] = 0.25 * (u[i - 1, j] + u[i + 1, j] + u[i, j - 1] + u[i, j + 1])

    bench(f"Jacobi {n}^2", run, max(3, (1 << 23) // (n * n)))


def laplacian(n):
    p, q = ti.field(ti.f32, (n, n, n)), ti.field(ti.f32, (n, n, n))

    @ti.kernel
    def run():
        for i, j, k in p:
            if 0 < i < n - 1 and 0 < j < n - 1 and 0 < k < n - 1:
                q[i, j, k] = (p[i - 1, j, k] + p[i + 1, j, k] + p[i, j - 1, k] + p[i, j + 1, k]
                              + p[i, j, k - 1] + p[i, j, k + 1] - 6 * p[i, j, k])

    bench(f"7-point Laplacian {n}^3", run, max(3, (1 << 23) // n**3))


def particle_to_grid(count, n, ordered):
    """Particles as in `benches/workloads`: interleaved, sorted by cell or as they are drawn, over interleaved nodes."""
    Point = ti.types.struct(x=ti.math.vec2, v=ti.math.vec2, c=ti.math.mat2, j=ti.f32)
    Node = ti.types.struct(v=ti.math.vec2, m=ti.f32)
    points, grid = Point.field(shape=count), Node.field(shape=(n, n))
    dx, dt = 1.0 / n, 1e-4
    mass, volume, stiffness = (dx * 0.5) ** 2, (dx * 0.5) ** 2, 400.0
    x = np.random.default_rng(7).uniform(0.1, 0.9, (count, 2)).astype(np.float32)
    cell = (x * n - 0.5).astype(np.int64)
    order = np.argsort(cell[:, 0] * n + cell[:, 1], kind="stable") if ordered else np.arange(count)
    points.x.from_numpy(x[order])
    points.j.fill(1.01)

    @ti.kernel
    def run():
        for p in points:
            xp = points[p].x / dx
            base = (xp - 0.5).cast(int)
            fx = xp - base
            w = [0.5 * (1.5 - fx) ** 2, 0.75 - (fx - 1) ** 2, 0.5 * (fx - 0.5) ** 2]
            stress = -dt * 4 * stiffness * volume * (points[p].j - 1) / dx**2
            affine = ti.Matrix([[stress, 0.0], [0.0, stress]]) + mass * points[p].c
            for i, j in ti.static(ti.ndrange(3, 3)):
                offset = ti.Vector([i, j])
                dpos = (offset - fx) * dx
                weight = w[i].x * w[j].y
                grid[base + offset].v += weight * (mass * points[p].v + affine @ dpos)
                grid[base + offset].m += weight * mass

    bench(f"P2G 2^{int(math.log2(count))} on {n}^2, {'sorted' if ordered else 'as drawn'}", run, 3)


for size in (1 << 24, 1 << 20, 1 << 17):
    total(size)
for size in (2048, 1024, 256):
    jacobi(size)
for size in (192, 96, 48):
    laplacian(size)
particle_to_grid(1 << 18, 512, True)
particle_to_grid(1 << 18, 512, False)
particle_to_grid(1 << 20, 1024, False)
