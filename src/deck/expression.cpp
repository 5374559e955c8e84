#include "deck/expression.h"

#include "deck/number.h"

#include <array>
#include <cctype>
#include <cmath>
#include <string>

namespace drawbead {

namespace {

using Lookup = std::function<std::optional<double>(std::string_view)>;

class Parser {
public:
    Parser(std::string_view text, const Lookup& name) : text_(text), name_(name) {}

    std::optional<double> run() {
        const auto value = sum();
        skip();
        if (!value || at_ != text_.size() || !std::isfinite(*value)) return std::nullopt;
        return value;
    }

private:
    static constexpr int deepest = 200;

    void skip() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])))
            ++at_;
    }
    bool take(std::string_view token) {
        skip();
        if (text_.substr(at_, token.size()) != token) return false;
        at_ += token.size();
        return true;
    }

    std::optional<double> sum() {
        auto left = product();
        while (left) {
            const bool plus = take("+");
            if (!plus && !take("-")) return left;
            const auto right = product();
            if (!right) return std::nullopt;
            left = plus ? *left + *right : *left - *right;
        }
        return left;
    }

    std::optional<double> product() {
        auto left = power();
        while (left) {
            skip();
            const bool times = text_.substr(at_, 2) != "**" && take("*");
            if (!times && !take("/")) return left;
            const auto right = power();
            if (!right) return std::nullopt;
            left = times ? *left * *right : *left / *right;
        }
        return left;
    }

    std::optional<double> power() {
        const auto base = unary();
        if (!base || (!take("^") && !take("**"))) return base;
        const Depth depth(*this);
        if (!depth.fine()) return std::nullopt;
        const auto exponent = power();
        if (!exponent) return std::nullopt;
        return std::pow(*base, *exponent);
    }

    std::optional<double> unary() {
        const Depth depth(*this);
        if (!depth.fine()) return std::nullopt;
        if (take("+")) return unary();
        if (take("-")) {
            const auto value = power();
            if (!value) return std::nullopt;
            return -*value;
        }
        if (take("(")) {
            const auto value = sum();
            return take(")") ? value : std::nullopt;
        }
        skip();
        if (at_ < text_.size() && (std::isdigit(static_cast<unsigned char>(text_[at_])) || text_[at_] == '.'))
            return number();
        return word();
    }

    std::optional<double> number() {
        std::size_t end = at_;
        auto digits = [&] {
            while (end < text_.size() && std::isdigit(static_cast<unsigned char>(text_[end])))
                ++end;
        };
        digits();
        if (end < text_.size() && text_[end] == '.') ++end;
        digits();
        if (end < text_.size() && std::string_view("eEdD").find(text_[end]) != std::string_view::npos) {
            std::size_t exponent = end + 1;
            if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-')) ++exponent;
            if (exponent < text_.size() && std::isdigit(static_cast<unsigned char>(text_[exponent]))) {
                end = exponent;
                digits();
            }
        }
        const RealCell cell = parse_real(text_.substr(at_, end - at_));
        at_ = end;
        if (cell.state != NumberState::ok) return std::nullopt;
        return cell.value;
    }

    std::optional<double> word() {
        take("&");
        std::size_t end = at_;
        while (end < text_.size() &&
               (std::isalnum(static_cast<unsigned char>(text_[end])) || text_[end] == '_'))
            ++end;
        if (end == at_) return std::nullopt;
        const std::string_view name = text_.substr(at_, end - at_);
        at_ = end;
        if (!take("(")) return name_(name);
        const auto first = sum();
        if (!first) return std::nullopt;
        if (take(",")) {
            const auto second = sum();
            if (!second || !take(")")) return std::nullopt;
            if (lower(name) == "min") return std::fmin(*first, *second);
            if (lower(name) == "max") return std::fmax(*first, *second);
            if (lower(name) == "atan2") return std::atan2(*first, *second);
            if (lower(name) == "mod") return std::fmod(*first, *second);
            return std::nullopt;
        }
        if (!take(")")) return std::nullopt;
        return apply(lower(name), *first);
    }

    static std::string lower(std::string_view name) {
        std::string text(name);
        for (char& c : text)
            c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        return text;
    }

    static std::optional<double> apply(const std::string& name, double x) {
        struct Function {
            std::string_view name;
            double (*of)(double);
        };
        static constexpr std::array<Function, 18> functions{
            {{"sin", [](double v) { return std::sin(v); }},
             {"cos", [](double v) { return std::cos(v); }},
             {"tan", [](double v) { return std::tan(v); }},
             {"asin", [](double v) { return std::asin(v); }},
             {"acos", [](double v) { return std::acos(v); }},
             {"atan", [](double v) { return std::atan(v); }},
             {"sinh", [](double v) { return std::sinh(v); }},
             {"cosh", [](double v) { return std::cosh(v); }},
             {"tanh", [](double v) { return std::tanh(v); }},
             {"exp", [](double v) { return std::exp(v); }},
             {"log", [](double v) { return std::log(v); }},
             {"ln", [](double v) { return std::log(v); }},
             {"log10", [](double v) { return std::log10(v); }},
             {"sqrt", [](double v) { return std::sqrt(v); }},
             {"abs", [](double v) { return std::abs(v); }},
             {"int", [](double v) { return std::trunc(v); }},
             {"floor", [](double v) { return std::floor(v); }},
             {"ceil", [](double v) { return std::ceil(v); }}}};
        for (const Function& f : functions)
            if (f.name == name) return f.of(x);
        return std::nullopt;
    }

    class Depth {
    public:
        explicit Depth(Parser& parser) : parser_(parser) { ++parser_.depth_; }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;
        ~Depth() { --parser_.depth_; }
        bool fine() const { return parser_.depth_ <= deepest; }

    private:
        Parser& parser_;
    };

    std::string_view text_;
    const Lookup& name_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

} // namespace

std::optional<double> evaluate_expression(std::string_view text, const Lookup& name) {
    return Parser(text, name).run();
}

} // namespace drawbead
