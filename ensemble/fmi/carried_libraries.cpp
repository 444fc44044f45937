// The definitions of fmt and xxHash, so that an FMU brings them along: its host may have others, or none. Of fmt 9,
// which Debian 12 has; built with another version, the FMU needs that as a library.

#define XXH_STATIC_LINKING_ONLY
#define XXH_IMPLEMENTATION
#include <xxhash.h>

#undef FMT_SHARED  // which would export them
#include <fmt/core.h>

#if FMT_VERSION / 10000 == 9
#include <fmt/format-inl.h>

FMT_BEGIN_NAMESPACE

template detail::dragonbox::decimal_fp<float> detail::dragonbox::to_decimal(float);
template detail::dragonbox::decimal_fp<double> detail::dragonbox::to_decimal(double);
template void detail::vformat_to(buffer<char>&, string_view, basic_format_args<FMT_BUFFER_CONTEXT(char)>,
                                 detail::locale_ref);
template detail::thousands_sep_result<char> detail::thousands_sep_impl(locale_ref);
template char detail::decimal_point_impl(locale_ref);
template void detail::buffer<char>::append(const char*, const char*);

FMT_END_NAMESPACE
#endif
