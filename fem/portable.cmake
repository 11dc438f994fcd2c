# The portable files, by the beginnings of their paths. What a portable file includes, directly or not, is portable too:
# Eigen, Boost, the JSON header and the standard library without files and threads, but no deal.II, TBB, MPI or POSIX. These
# files run in a browser (STEMWARE_EXPLORE); tests/check_includes.cmake and the test portable_alone hold them to that.
set(STEMWARE_PORTABLE
    ring_model/
    fem/geometry/boundary_ids.
    fem/geometry/contact_cells.
    fem/geometry/elastic_material.
    fem/geometry/foot_resolution.
    fem/geometry/glass_profile.
    fem/geometry/gmsh_file.
    fem/geometry/linear_solver.
    fem/geometry/meridian_section.
    fem/geometry/mesh_content.
    fem/geometry/mesh_report.
    fem/geometry/require.
    fem/geometry/rim_circle.
    fem/geometry/section_lengths.
    fem/geometry/table_disc.
    fem/geometry/waviness.
    fem/contact/
    fem/revolution/body_of_revolution.
    fem/revolution/contact_compliance.
    fem/revolution/dense_algebra.
    fem/revolution/elastic_response.
    fem/revolution/fourier_basis.
    fem/revolution/harmonic_stiffness.
    fem/revolution/line_bundle.
    fem/revolution/line_newton.
    fem/revolution/moment_continuation.
    fem/revolution/pressure_field.
    fem/revolution/revolution_contact.
    fem/revolution/revolution_foot.
    fem/revolution/revolution_setup.
    fem/revolution/target_clones.
    fem/pipeline/support/
    fem/pipeline/study/
    fem/pipeline/coupling/
    fem/pipeline/variants/
    fem/pipeline/analysis/
    fem/pipeline/pictures/
    fem/pipeline/explore/)
list(JOIN STEMWARE_PORTABLE "|" STEMWARE_PORTABLE)
string(REPLACE "." "\\." STEMWARE_PORTABLE "(${STEMWARE_PORTABLE})") # a regular expression
