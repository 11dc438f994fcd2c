#pragma once

/// deal.II's mesh. Its header takes long to parse.
namespace dealii
{
template <int dim, int spacedim>
class Triangulation;
}
