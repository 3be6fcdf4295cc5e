// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "vsi/quiet_errors.h"

#include "base/text.h"

namespace qmesh {

QuietErrors::QuietErrors() {
  CPLPushErrorHandlerEx(handle, this);
}

QuietErrors::~QuietErrors() {
  CPLPopErrorHandler();
  CPLErrorReset();
}

std::string QuietErrors::explain(const std::string& sentence) const {
  return failure_.empty() ? sentence : sentence + " (" + failure_ + ")";
}

void CPL_STDCALL QuietErrors::handle(CPLErr kind, CPLErrorNum, const char* text) {
  auto* self = static_cast<QuietErrors*>(CPLGetErrorHandlerUserData());
  if (kind >= CE_Failure && self->failure_.empty())
    self->failure_ = trimmed(text);
}

} // namespace qmesh
