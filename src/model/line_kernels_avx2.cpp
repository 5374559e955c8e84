// Lines of 10-column integers and 20-column reals with AVX2, chosen at run time. Instructions of the wider
// set stay inside functions that are marked for it, so the rest of the program runs anywhere.
#include "model/line_kernels.h"

#if defined(__x86_64__)
#include <bit>
#include <immintrin.h>

#define DRAWBEAD_WIDE __attribute__((target("avx2,bmi,bmi2,popcnt")))
#define DRAWBEAD_WIDE_INLINE __attribute__((target("avx2,bmi,bmi2,popcnt"), always_inline)) inline

namespace drawbead {

namespace {

/// 16 bytes from `last_bytes + n` on: the last n of them set.
alignas(32) constexpr uint8_t last_bytes[32] = {
    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,
    0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff};

/// Powers of ten that a double holds exactly: with a mantissa below 2^53, one multiplication or division by
/// them is correctly rounded.
constexpr double power_of_ten[23] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                     1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// Bytes that a kernel may touch around the line at hand.
constexpr std::ptrdiff_t bytes_before = 16, bytes_after = 96;

DRAWBEAD_WIDE_INLINE __m128i load(const void* at) {
    return _mm_loadu_si128(static_cast<const __m128i*>(at));
}
DRAWBEAD_WIDE_INLINE __m256i load_wide(const void* at) {
    return _mm256_loadu_si256(static_cast<const __m256i*>(at));
}

DRAWBEAD_WIDE_INLINE uint32_t digits_in(__m256i text) {
    const __m256i value = _mm256_sub_epi8(text, _mm256_set1_epi8('0'));
    return static_cast<uint32_t>(
        _mm256_movemask_epi8(_mm256_cmpeq_epi8(_mm256_min_epu8(value, _mm256_set1_epi8(9)), value)));
}
DRAWBEAD_WIDE_INLINE uint32_t equal_in(__m256i text, char c) {
    return static_cast<uint32_t>(_mm256_movemask_epi8(_mm256_cmpeq_epi8(text, _mm256_set1_epi8(c))));
}

/// Four numbers of 16 digits each (0 … 9, the most significant first), in the order
/// {low lane of a, low lane of b, high lane of a, high lane of b}.
DRAWBEAD_WIDE_INLINE __m256i join_digits(__m256i a, __m256i b) {
    const __m256i tens = _mm256_set1_epi16(0x010a);         // 10, 1
    const __m256i hundreds = _mm256_set1_epi32(0x00010064); // 100, 1
    const __m256i a4 = _mm256_madd_epi16(_mm256_maddubs_epi16(a, tens), hundreds);
    const __m256i b4 = _mm256_madd_epi16(_mm256_maddubs_epi16(b, tens), hundreds);
    const __m256i four = _mm256_packus_epi32(a4, b4);
    const __m256i eight = _mm256_madd_epi16(four, _mm256_set1_epi32(0x00012710)); // 10000, 1
    return _mm256_add_epi64(_mm256_mul_epu32(eight, _mm256_set1_epi64x(100000000)),
                            _mm256_srli_epi64(eight, 32));
}

/// A real as written: the digits right-aligned without the point, value = digits · 10^exponent.
struct Decimal {
    __m128i digits;
    int exponent;
    bool negative;
};

/// Takes apart a cell of 20 columns: blanks, sign, digits with at most one point, exponent with a letter,
/// blanks. False when the cell is blank, is not of that form, or has more than 16 digits.
DRAWBEAD_WIDE_INLINE bool take_apart(const char* cell, Decimal& out) {
    constexpr uint32_t columns20 = (1u << 20) - 1;
    const __m256i text = load_wide(cell);
    uint32_t digits = digits_in(text) & columns20;
    const uint32_t filled = ~equal_in(text, ' ') & columns20;
    uint32_t point = equal_in(text, '.') & columns20;
    if (filled == 0) return false;
    const uint32_t begin = static_cast<uint32_t>(std::countr_zero(filled));
    const uint32_t run = filled >> begin;
    if (run & (run + 1)) return false; // a blank inside
    uint32_t end = begin + static_cast<uint32_t>(std::countr_one(run));
    out.negative = cell[begin] == '-';
    const uint32_t other = filled & ~(digits | point) & ~(static_cast<uint32_t>(out.negative) << begin);
    int exponent = 0;
    if (other != 0) {
        const uint32_t letter_at = static_cast<uint32_t>(std::countr_zero(other));
        const char letter = static_cast<char>(cell[letter_at] | 0x20);
        if (letter != 'e' && letter != 'd') return false;
        uint32_t at = letter_at + 1;
        const bool down = at < end && cell[at] == '-';
        if (at < end && (down || cell[at] == '+')) ++at;
        if (at >= end || end - at > 3) return false;
        for (; at < end; ++at) {
            if (!(digits >> at & 1u)) return false;
            exponent = 10 * exponent + (cell[at] - '0');
        }
        if (down) exponent = -exponent;
        end = letter_at;
        digits &= (1u << end) - 1;
        if (point >> end) return false;
    }
    if (point & (point - 1)) return false;
    const uint32_t count = static_cast<uint32_t>(std::popcount(digits));
    if (count - 1 > 15) return false;
    const uint32_t decimals = end - 1 - static_cast<uint32_t>(std::countr_zero(point));
    out.exponent = point ? exponent - static_cast<int>(decimals) : exponent;
    // Digits behind the point stay, those before it move up by one place.
    const __m128i stay = load(last_bytes + (point ? decimals : 16));
    const __m128i joined = _mm_blendv_epi8(load(cell + end - 17), load(cell + end - 16), stay);
    out.digits = _mm_and_si128(_mm_sub_epi8(joined, _mm_set1_epi8('0')), load(last_bytes + count));
    return true;
}

DRAWBEAD_WIDE_INLINE bool exact(const Decimal& d) {
    return static_cast<uint32_t>(d.exponent + 22) <= 44;
}

/// What stands in the 60 columns of three cells: a bit for each, from the first column on.
struct Columns60 {
    uint64_t digit, blank, point, minus;
};

DRAWBEAD_WIDE_INLINE uint64_t join_columns(uint32_t low, uint32_t high) {
    return (low | uint64_t{high} << 32) & ((uint64_t{1} << 60) - 1);
}

constexpr uint64_t first_columns = 1 | uint64_t{1} << 20 | uint64_t{1} << 40;

/// Takes apart three mantissas that end in column `width` of their cells: blanks, a minus or none, digits
/// with one point among them. False when they are not of that form or have more than 16 digits.
template <uint32_t width>
DRAWBEAD_WIDE_INLINE bool take_mantissas(const char* cells, const Columns60& text, Decimal* to) {
    constexpr uint64_t inside = (first_columns << width) - first_columns, last = first_columns << (width - 1);
    const uint64_t digit = text.digit & inside, point = text.point & inside, minus = text.minus & inside;
    const uint64_t filled = ~text.blank & inside;
    const uint64_t begin = filled & ~((filled & ~last) << 1);
    const uint64_t wrong =
        (filled & ~(filled >> 1) & ~last) | (last & ~filled) | (filled & ~(digit | point | (minus & begin)));
    if (wrong != 0 || std::popcount(point) != 3) return false;
    for (uint32_t k = 0; k < 3; ++k) {
        constexpr uint32_t cell = (1u << 20) - 1;
        const uint32_t at = static_cast<uint32_t>(point >> 20 * k) & cell;
        const uint32_t count =
            static_cast<uint32_t>(std::popcount(static_cast<uint32_t>(digit >> 20 * k) & cell));
        if (at == 0 || count - 1 > 15) return false;
        const uint32_t decimals = width - 1 - static_cast<uint32_t>(std::countr_zero(at));
        const char* const end = cells + 20 * k + width;
        const __m128i joined = _mm_blendv_epi8(load(end - 17), load(end - 16), load(last_bytes + decimals));
        to[k].digits = _mm_and_si128(_mm_sub_epi8(joined, _mm_set1_epi8('0')), load(last_bytes + count));
        to[k].exponent = -static_cast<int>(decimals);
        to[k].negative = (static_cast<uint32_t>(minus >> 20 * k) & cell) != 0;
    }
    return true;
}

/// Three cells of 20 columns at once when all are as a fixed format writes them: up to the last column, or
/// up to an exponent like E+01 there. False when they are not, or are not exact().
DRAWBEAD_WIDE_INLINE bool take_three_apart(const char* cells, Decimal* to) {
    const __m256i low = load_wide(cells), high = load_wide(cells + 32);
    const Columns60 text{join_columns(digits_in(low), digits_in(high)),
                         join_columns(equal_in(low, ' '), equal_in(high, ' ')),
                         join_columns(equal_in(low, '.'), equal_in(high, '.')),
                         join_columns(equal_in(low, '-'), equal_in(high, '-'))};
    if (take_mantissas<20>(cells, text, to)) return true;
    const uint64_t letter = join_columns(equal_in(low, 'E'), equal_in(high, 'E'));
    const uint64_t sign = text.minus | join_columns(equal_in(low, '+'), equal_in(high, '+'));
    if (letter != first_columns << 16) return false;
    if ((sign >> 17 & text.digit >> 18 & text.digit >> 19 & first_columns) != first_columns) return false;
    if (!take_mantissas<16>(cells, text, to)) return false;
    for (uint32_t k = 0; k < 3; ++k) {
        const char* const end = cells + 20 * k + 16;
        const int written = 10 * (end[2] - '0') + (end[3] - '0');
        to[k].exponent += end[1] == '-' ? -written : written;
        if (!exact(to[k])) return false;
    }
    return true;
}

DRAWBEAD_WIDE_INLINE double value_of(uint64_t mantissa, const Decimal& d) {
    double value = static_cast<double>(static_cast<int64_t>(mantissa));
    if (d.exponent <= 0)
        value /= power_of_ten[-d.exponent];
    else
        value *= power_of_ten[d.exponent];
    return d.negative ? -value : value;
}

/// The start of the line after the blanks at `at`; nullptr when there is something else before the newline.
DRAWBEAD_WIDE_INLINE const char* after_blanks(const char* at, const char* end) {
    while (at < end && (*at == ' ' || *at == '\r' || *at == '\t'))
        ++at;
    return at < end && *at == '\n' ? at + 1 : nullptr;
}

/// The start of the line after the text at `at`, and that text; nullptr when it holds a comma.
const char* after_text(const char* at, const char* end, std::string_view& text) {
    const char* const stop = line_end(at, end);
    if (stop == end) return nullptr;
    text = {at, static_cast<std::size_t>(stop - at - (stop[-1] == '\r'))};
    return text.find(',') == std::string_view::npos ? stop + 1 : nullptr;
}

template <uint32_t cells>
DRAWBEAD_WIDE void read_cells(LineRange& range, IdRows& rows) {
    constexpr uint64_t filled_columns = (uint64_t{1} << 10 * cells) - 1;
    constexpr uint64_t last_columns =
        (uint64_t{1} << 9 | uint64_t{1} << 19 | uint64_t{1} << 29 | uint64_t{1} << 39 | uint64_t{1} << 49) &
        filled_columns;
    const __m256i align = _mm256_setr_epi8(-1, -1, -1, -1, -1, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, -1, -1, -1,
                                           -1, -1, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9);
    const __m256i low = _mm256_set1_epi8(0x0f); // '0' … '9' to 0 … 9, and a blank to 0
    if (range.file.size() < bytes_after) return;
    const char* at = range.at;
    const char* const safe = range.file.data() + range.file.size() - bytes_after;
    const char* const end = range.end;
    std::size_t count = rows.count;
    while (at < end && at <= safe && count < rows.capacity) {
        const __m256i first = load_wide(at), second = load_wide(at + 32);
        const uint64_t digits = (digits_in(first) | uint64_t{digits_in(second)} << 32) & filled_columns;
        const uint64_t filled =
            ~(equal_in(first, ' ') | uint64_t{equal_in(second, ' ')} << 32) & filled_columns;
        // Only digits, and after a digit a blank only where a cell ends.
        if (filled != digits || (filled & ~(filled >> 1) & ~last_columns)) break;
        std::string_view more;
        const char* next = at[10 * cells] == '\n' ? at + 10 * cells + 1 : after_blanks(at + 10 * cells, end);
        if (!next) {
            next = after_text(at + 10 * cells, end, more);
            if (!next) break;
        }
        const __m256i c01 = _mm256_inserti128_si256(_mm256_castsi128_si256(load(at)), load(at + 10), 1);
        const __m256i c23 = _mm256_inserti128_si256(_mm256_castsi128_si256(load(at + 20)), load(at + 30), 1);
        alignas(32) uint64_t value[4]; // cells 0, 2, 1, 3
        _mm256_store_si256(reinterpret_cast<__m256i*>(value),
                           join_digits(_mm256_and_si256(_mm256_shuffle_epi8(c01, align), low),
                                       _mm256_and_si256(_mm256_shuffle_epi8(c23, align), low)));
        uint64_t all = value[0] | value[1] | value[2] | value[3];
        uint32_t* const to = rows.values + count * cells;
        if constexpr (cells == 5) {
            const __m256i c4 = _mm256_castsi128_si256(load(at + 40));
            const __m256i fifth =
                join_digits(_mm256_and_si256(_mm256_shuffle_epi8(c4, align), low), _mm256_setzero_si256());
            const uint64_t last = static_cast<uint64_t>(_mm256_extract_epi64(fifth, 0));
            all |= last;
            to[4] = static_cast<uint32_t>(last);
        }
        if (all > largest_id || value[0] == 0) break;
        to[0] = static_cast<uint32_t>(value[0]);
        to[1] = static_cast<uint32_t>(value[2]);
        to[2] = static_cast<uint32_t>(value[1]);
        to[3] = static_cast<uint32_t>(value[3]);
        rows.more[count] = more;
        ++count;
        at = next;
    }
    range.at = at;
    rows.count = count;
}

} // namespace

DRAWBEAD_WIDE void read_node_lines_avx2(LineRange& range, NodeRows& rows) {
    if (range.file.size() < bytes_after || range.at - range.file.data() < bytes_before) return;
    const char* at = range.at;
    const char* const safe = range.file.data() + range.file.size() - bytes_after;
    const char* const end = range.end;
    std::size_t count = rows.count;
    while (at < end && at <= safe && count < rows.capacity) {
        const __m256i head = load_wide(at);
        constexpr uint32_t columns10 = (1u << 10) - 1;
        const uint32_t digits = digits_in(head) & columns10;
        const uint32_t filled = ~equal_in(head, ' ') & columns10;
        if (filled != digits || filled == 0) break;
        const uint32_t run = filled >> std::countr_zero(filled);
        if (run & (run + 1)) break;
        Decimal cell[3];
        const Decimal &x = cell[0], &y = cell[1], &z = cell[2];
        if (!take_three_apart(at + 10, cell)) {
            if (!take_apart(at + 10, cell[0]) || !take_apart(at + 30, cell[1]) ||
                !take_apart(at + 50, cell[2]))
                break;
            if (!exact(x) || !exact(y) || !exact(z)) break;
        }
        const char* const next = at[70] == '\n' ? at + 71 : after_blanks(at + 70, end);
        if (!next) break;
        const __m128i id =
            _mm_and_si128(_mm_sub_epi8(load(at + 16 - std::countl_zero(filled)), _mm_set1_epi8('0')),
                          load(last_bytes + std::popcount(filled)));
        alignas(32) uint64_t value[4]; // id, y, x, z
        _mm256_store_si256(
            reinterpret_cast<__m256i*>(value),
            join_digits(_mm256_inserti128_si256(_mm256_castsi128_si256(id), x.digits, 1),
                        _mm256_inserti128_si256(_mm256_castsi128_si256(y.digits), z.digits, 1)));
        const int64_t global = static_cast<int64_t>(value[0]) + rows.id_offset;
        if (value[0] - 1 >= largest_id || global < 1 || global > largest_id) break;
        if ((value[1] | value[2] | value[3]) >> 53) break;
        rows.id[count] = static_cast<uint32_t>(global);
        rows.x[count] = {value_of(value[2], x) * rows.factor, value_of(value[1], y) * rows.factor,
                         value_of(value[3], z) * rows.factor};
        ++count;
        at = next;
    }
    range.at = at;
    rows.count = count;
}

void read_id_lines_avx2(LineRange& range, IdRows& rows) {
    if (rows.cells == 5)
        read_cells<5>(range, rows);
    else
        read_cells<4>(range, rows);
}

} // namespace drawbead

#endif
