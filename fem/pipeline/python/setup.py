"""Builds stemware.ring, the ring model, from a checkout: pip install ./fem/pipeline/python --no-build-isolation

Compiles ring_model/ of this checkout with the headers of Eigen, Boost and pybind11. stemware.Study needs deal.II and is built
by CMake.
"""
import atexit
import glob
import os
import re
import shutil
import subprocess
import tempfile

from pybind11.setup_helpers import ParallelCompile, Pybind11Extension
from setuptools import setup

os.chdir(os.path.dirname(os.path.abspath(__file__)))
top = os.path.relpath("../../..")
with open(os.path.join(top, "CMakeLists.txt")) as file:
    version = re.search(r"set\(STEMWARE_VERSION ([^)]*)\)", file.read()).group(1).replace("~", ".")


def eigen():
    found = subprocess.run(["pkg-config", "--cflags-only-I", "eigen3"], stdout=subprocess.PIPE, text=True).stdout.strip()
    return found[2:] or "/usr/include/eigen3"


# Objects go where their sources' "../../.." leads from the build: three folders deep, they stay in the temporary one.
scratch = tempfile.mkdtemp(prefix="stemware-")
atexit.register(shutil.rmtree, scratch, ignore_errors=True)
build = os.path.join(scratch, "ring", "python", "build")
os.makedirs(build)

sources = ["ring_bindings.cc", *sorted(glob.glob(top + "/ring_model/*.cc") + glob.glob(top + "/ring_model/*/*.cc"))]
ParallelCompile("STEMWARE_COMPILERS", default=2).install()
setup(
    name="stemware",
    version=version,
    description="The Coulomb ring that slides and spins: limit surfaces, terminal spins",
    license="MIT",
    python_requires=">=3.9",
    install_requires=["numpy"],
    packages=["stemware"],
    package_data={"stemware": ["py.typed", "*.pyi"]},
    options={"build": {"build_base": build}, "egg_info": {"egg_base": build}},
    ext_modules=[Pybind11Extension("stemware._ring", sources, include_dirs=[top, eigen()], cxx_std=17,
                                   define_macros=[("STEMWARE_VERSION", f'"{version}"')])],
)
