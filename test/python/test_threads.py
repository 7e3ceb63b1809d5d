# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Python's lock is free while the library computes, and Ctrl-C ends it."""
import signal
import subprocess
import sys
import threading

import numpy as np
import pytest

import pcl_shape
from conftest import same

INTERRUPTED = """
import os, signal, sys, threading
import numpy as np
import pcl_shape
points = np.random.default_rng(3).uniform(0, 1, (1_000_000, 3)).astype(np.float32)
reached = threading.Event()
def interrupt():
    reached.wait()
    os.kill(os.getpid(), signal.SIGINT)
threading.Thread(target=interrupt, daemon=True).start()
sweep = pcl_shape.NeighborhoodSweep(points)
try:
    threading.Timer(0.3, reached.set).start()
    sweep.count_neighbors(radius=0.5)  # all pairs: this takes hours
except KeyboardInterrupt:
    print("interrupted")
    counts = pcl_shape.NeighborhoodSweep(points[:100]).count_neighbors(radius=2.0)
    print((counts == 99).all())
"""


def test_ctrl_c():
    """Also the interpreter ends: it waits for what is left of the computation."""
    done = subprocess.run([sys.executable, "-c", INTERRUPTED], stdout=subprocess.PIPE, text=True, timeout=300)
    assert done.stdout.split() == ["interrupted", "True"] and done.returncode == 0


def test_a_handler_that_raises_is_heard():
    class Late(Exception):
        pass

    def raise_late(*_):
        raise Late

    points = np.random.default_rng(3).uniform(0, 1, (1_000_000, 3)).astype(np.float32)
    sweep = pcl_shape.NeighborhoodSweep(points)
    before = signal.signal(signal.SIGALRM, raise_late)
    try:
        with pytest.raises(Late):
            signal.setitimer(signal.ITIMER_REAL, 0.2)
            sweep.count_neighbors(radius=0.5)
    finally:
        signal.signal(signal.SIGALRM, before)


def test_the_lock_is_free(scene):
    """Another thread runs Python while one computes: it stops the computation."""
    points = np.random.default_rng(3).uniform(0, 1, (1_000_000, 3)).astype(np.float32)
    sweep = pcl_shape.NeighborhoodSweep(points)
    ran = []

    def stop():
        ran.append(pcl_shape.NeighborhoodSweep(scene).count_neighbors(radius=0.02))
        signal.raise_signal(signal.SIGINT)

    other = threading.Thread(target=stop)
    with pytest.raises(KeyboardInterrupt):
        other.start()
        sweep.count_neighbors(radius=0.5)
    other.join()
    assert len(ran) == 1


def test_many_threads(scene):
    expected = pcl_shape.detect(scene).likelihoods
    results = [None] * 3

    def run(i):
        results[i] = pcl_shape.detect(scene, threads=1).likelihoods

    threads = [threading.Thread(target=run, args=(i,)) for i in range(len(results))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(same(result, expected) for result in results)
