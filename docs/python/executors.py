"""Maps the terminal spin over speed and friction. Any executor solves the studies: one process, threads, processes,
dask workers, or MPI ranks, here all on this machine.

    python3 docs/python/executors.py map.svg                        # also: threads, processes, dask
    mpiexec -n 3 python3 -m mpi4py.futures docs/python/executors.py map.svg mpi
"""
import contextlib
import logging
import sys
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np

import stemware


@contextlib.contextmanager
def executor_named(kind):
    if kind == "threads":
        with ThreadPoolExecutor(2) as executor:
            yield executor
    elif kind == "processes":
        with ProcessPoolExecutor(2) as executor:
            yield executor
    elif kind == "dask":  # for a scheduler on another machine: Client("tcp://...")
        from distributed import Client, LocalCluster
        # Only errors are logged: on a busy machine, dask warns of workers that end slowly.
        with LocalCluster(2, threads_per_worker=1, host="127.0.0.1", dashboard_address=None,
                          silence_logs=logging.ERROR) as cluster, Client(cluster) as client:
            yield client.get_executor()
    elif kind == "mpi":
        from mpi4py.futures import MPIPoolExecutor
        with MPIPoolExecutor() as executor:
            yield executor
    else:
        yield None


if __name__ == "__main__":
    kind = sys.argv[2] if len(sys.argv) > 2 else "none"
    speed, mu = np.linspace(0.2, 0.5, 5), np.linspace(0.1, 0.5, 5)
    cases = [{"Motion/Orbit speed": v, "Motion/Friction coefficient": f} for f in mu for v in speed]
    with executor_named(kind) as executor:
        found = stemware.solve([*cases, {"Motion/Mass": "30 cm"}], executor=executor)
    solved = found[found["failure"] == ""]
    spins = solved["omega_terminal"].to_numpy(float)
    print(f"{len(solved)} studies: {spins.min():.12f} to {spins.max():.12f} rad/s")
    print(f"the other one: {found['failure'].iloc[-1]}")

    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, ax = plt.subplots(figsize=(4.6, 3.4), layout="constrained")
    lines = ax.contourf(speed, mu, spins.reshape(mu.size, speed.size), 12)
    figure.colorbar(lines, ax=ax, label="terminal spin (rad/s)")
    ax.set(xlabel="orbit speed (m/s)", ylabel="friction coefficient")
    figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "map.svg")
