"""Builds the extensions of the package with CMake; pyproject.toml has the metadata.

With deal.II and the other packages of packages.txt the package has stemware.Study; without deal.II it has the ring model only.
The environment variable STEMWARE_CMAKE_ARGUMENTS adds arguments of CMake, for instance "-D STEMWARE_FEM=OFF".
"""
import os
import pathlib
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

here = pathlib.Path(__file__).resolve().parent
sources = here / "sources" if (here / "sources").exists() else here.parents[2]  # in an sdist, in a checkout
build = sources / "build" / "pip"  # ignored by git
build.mkdir(parents=True, exist_ok=True)


def version():
    """Returns the version in CMakeLists.txt in Python's notation (PEP 440)."""
    for line in (sources / "CMakeLists.txt").read_text().splitlines():
        if line.startswith("set(STEMWARE_VERSION "):
            return line.split()[1].rstrip(")").replace("~dev", ".dev0")
    raise SystemExit(f"{sources}/CMakeLists.txt does not set STEMWARE_VERSION")


class BuildByCMake(build_ext):
    """Builds both extensions by CMake; the second one exists only with deal.II."""

    def run(self):
        if not shutil.which("cmake"):
            raise SystemExit("Stemware is built by CMake 3.25 or newer, which is not installed: apt-get install cmake ninja-build")
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        more = shlex.split(os.environ.get("STEMWARE_CMAKE_ARGUMENTS", ""))
        binary = build / "cmake"
        subprocess.run(["cmake", "-S", sources, "-B", binary, *generator, "-D", "CMAKE_BUILD_TYPE=Release", "-D", "STEMWARE_WHEEL=ON",
                        "-D", f"Python_EXECUTABLE={sys.executable}", *more], check=True)
        subprocess.run(["cmake", "--build", binary, "--target", "stemware_python", "--parallel", str(self.parallel or os.cpu_count())], check=True)
        place = here if self.inplace else pathlib.Path(self.build_lib).resolve()
        subprocess.run(["cmake", "--install", binary, "--component", "python", "--prefix", place], check=True)

    def get_outputs(self):
        return [str(file) for file in pathlib.Path(self.build_lib, "stemware").glob("*.so")]


class WithSources(sdist):
    """Source distribution with all files that CMake reads."""

    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        ignore = shutil.ignore_patterns("build", "*.egg-info", "__pycache__", "*.pyc", "stemware-*")
        for name in ["ring_model", "fem"]:
            shutil.copytree(sources / name, pathlib.Path(base_dir, "sources", name), ignore=ignore)
        for name in ["CMakeLists.txt", "LICENSE"]:
            shutil.copy(sources / name, pathlib.Path(base_dir, "sources", name))


setup(
    version=version(),
    options={"build": {"build_base": str(build)}, "egg_info": {"egg_base": str(build)}},
    ext_modules=[Extension("stemware._ring", [])],
    cmdclass={"build_ext": BuildByCMake, "sdist": WithSources},
)
