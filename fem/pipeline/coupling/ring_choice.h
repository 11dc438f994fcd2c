#pragma once

#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/contact_section.h"
#include "ring_model/motion.h"

namespace stemware::pipeline
{

/// Chooses the rings of @p foot from the contact @p at_rest: Chebyshev points of its loaded band of radii, as
/// many as the slip ratio at the terminal spin of its load requires. Without such a spin: Contact/Rings.
void choose_rings(const ContactSection &contact, const ring::Motion &motion, ElasticFoot &foot,
                  const fem::ContactState &at_rest);

} // namespace stemware::pipeline
