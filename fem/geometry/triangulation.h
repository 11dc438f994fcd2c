#pragma once

/// Forward declaration of deal.II's mesh, whose header takes long to parse.
namespace dealii
{
template <int dim, int spacedim>
class Triangulation;
}
