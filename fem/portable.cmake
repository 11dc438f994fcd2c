# Portable files, as path prefixes. Everything that a portable file includes, directly or indirectly, is portable as
# well: Eigen, Boost, the JSON header and the standard library without files and threads, but no deal.II, TBB, MPI or
# POSIX. These files also run in a browser (STEMWARE_EXPLORE). Checked by tests/check_includes.cmake and the test
# portable_alone.
set(STEMWARE_PORTABLE
    ring_model/
    fem/geometry/boundary_ids.
    fem/geometry/contact_cells.
    fem/geometry/elastic_material.
    fem/geometry/foot_resolution.
    fem/geometry/glass_profile.
    fem/geometry/linear_solver.
    fem/geometry/meridian_section.
    fem/geometry/mesh_report.
    fem/geometry/require.
    fem/geometry/rim_circle.
    fem/geometry/section_lengths.
    fem/geometry/waviness.
    fem/contact/
    fem/revolution/body_of_revolution.
    fem/revolution/contact_compliance.
    fem/revolution/dense_algebra.
    fem/revolution/elastic_response.
    fem/revolution/fourier_basis.
    fem/revolution/line_newton.
    fem/revolution/revolution_contact.
    fem/revolution/revolution_foot.
    fem/revolution/revolution_setup.
    fem/pipeline/base/failures.
    fem/pipeline/base/json.h
    fem/pipeline/base/numbers.
    fem/pipeline/base/progress.
    fem/pipeline/base/text.
    fem/pipeline/study/column_table.
    fem/pipeline/study/contact_section.
    fem/pipeline/study/entry_facts.
    fem/pipeline/study/glass_section.
    fem/pipeline/study/load_section.
    fem/pipeline/study/motion_section.
    fem/pipeline/study/quantity_text.
    fem/pipeline/study/study.
    fem/pipeline/study/study_checks.
    fem/pipeline/study/study_entries.
    fem/pipeline/study/table_file.
    fem/pipeline/study/table_section.
    fem/pipeline/coupling/balanced_contact.
    fem/pipeline/coupling/balanced_load.
    fem/pipeline/coupling/foot_specification.
    fem/pipeline/coupling/elastic_foot.
    fem/pipeline/coupling/revolution_setup.
    fem/pipeline/coupling/study_load.
    fem/pipeline/analysis/budget.
    fem/pipeline/analysis/budget_quantities.
    fem/pipeline/analysis/driven_spin_up.
    fem/pipeline/analysis/quantity.
    fem/pipeline/analysis/ring_quantities.
    fem/pipeline/analysis/solve.
    fem/pipeline/analysis/spin_study.
    fem/pipeline/analysis/study_rows.
    fem/pipeline/analysis/variant.
    fem/pipeline/result/curves.
    fem/pipeline/result/pictures.
    fem/pipeline/result/results.
    fem/pipeline/page/explore_api.
    fem/pipeline/page/explorer.)
list(JOIN STEMWARE_PORTABLE "|" STEMWARE_PORTABLE)
string(REPLACE "." "\\." STEMWARE_PORTABLE "(${STEMWARE_PORTABLE})") # as a regular expression
