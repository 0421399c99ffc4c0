#include "app/page/tex_words.h"

#include <array>

namespace underact::page {
namespace {

constexpr auto kLetter = TexKind::Letter;
constexpr auto kUpright = TexKind::Upright;
constexpr auto kOperator = TexKind::Operator;
constexpr auto kSpace = TexKind::Space;

// Of the wide spaces Qt makes one narrow one, but not of those that do not break.
constexpr std::array kWords{
    TexWord{"alpha", kLetter, "α"},
    TexWord{"beta", kLetter, "β"},
    TexWord{"gamma", kLetter, "γ"},
    TexWord{"delta", kLetter, "δ"},
    TexWord{"epsilon", kLetter, "ϵ"},
    TexWord{"varepsilon", kLetter, "ε"},
    TexWord{"zeta", kLetter, "ζ"},
    TexWord{"eta", kLetter, "η"},
    TexWord{"theta", kLetter, "θ"},
    TexWord{"kappa", kLetter, "κ"},
    TexWord{"lambda", kLetter, "λ"},
    TexWord{"mu", kLetter, "μ"},
    TexWord{"nu", kLetter, "ν"},
    TexWord{"xi", kLetter, "ξ"},
    TexWord{"pi", kLetter, "π"},
    TexWord{"rho", kLetter, "ρ"},
    TexWord{"sigma", kLetter, "σ"},
    TexWord{"tau", kLetter, "τ"},
    TexWord{"phi", kLetter, "ϕ"},
    TexWord{"varphi", kLetter, "φ"},
    TexWord{"chi", kLetter, "χ"},
    TexWord{"psi", kLetter, "ψ"},
    TexWord{"omega", kLetter, "ω"},
    TexWord{"Gamma", kUpright, "Γ"},
    TexWord{"Delta", kUpright, "Δ"},
    TexWord{"Theta", kUpright, "Θ"},
    TexWord{"Lambda", kUpright, "Λ"},
    TexWord{"Pi", kUpright, "Π"},
    TexWord{"Sigma", kUpright, "Σ"},
    TexWord{"Phi", kUpright, "Φ"},
    TexWord{"Psi", kUpright, "Ψ"},
    TexWord{"Omega", kUpright, "Ω"},
    TexWord{"sin", kUpright, "sin"},
    TexWord{"cos", kUpright, "cos"},
    TexWord{"tan", kUpright, "tan"},
    TexWord{"arcsin", kUpright, "arcsin"},
    TexWord{"arccos", kUpright, "arccos"},
    TexWord{"arctan", kUpright, "arctan"},
    TexWord{"exp", kUpright, "exp"},
    TexWord{"log", kUpright, "log"},
    TexWord{"ln", kUpright, "ln"},
    TexWord{"det", kUpright, "det"},
    TexWord{"min", kUpright, "min"},
    TexWord{"max", kUpright, "max"},
    TexWord{"lim", kUpright, "lim"},
    TexWord{"ker", kUpright, "ker"},
    TexWord{"arg", kUpright, "arg"},
    TexWord{"cdot", kOperator, "·"},
    TexWord{"times", kOperator, "×"},
    TexWord{"pm", kOperator, "±"},
    TexWord{"mp", kOperator, "∓"},
    TexWord{"le", kOperator, "≤"},
    TexWord{"leq", kOperator, "≤"},
    TexWord{"ge", kOperator, "≥"},
    TexWord{"geq", kOperator, "≥"},
    TexWord{"ne", kOperator, "≠"},
    TexWord{"neq", kOperator, "≠"},
    TexWord{"ll", kOperator, "≪"},
    TexWord{"gg", kOperator, "≫"},
    TexWord{"approx", kOperator, "≈"},
    TexWord{"equiv", kOperator, "≡"},
    TexWord{"propto", kOperator, "∝"},
    TexWord{"in", kOperator, "∈"},
    TexWord{"to", kOperator, "→"},
    TexWord{"rightarrow", kOperator, "→"},
    TexWord{"Rightarrow", kOperator, "⇒"},
    TexWord{"mapsto", kOperator, "↦"},
    TexWord{"perp", kOperator, "⊥"},
    TexWord{"parallel", kOperator, "∥"},
    TexWord{"otimes", kOperator, "⊗"},
    TexWord{"sum", kUpright, "∑"},
    TexWord{"prod", kUpright, "∏"},
    TexWord{"int", kUpright, "∫"},
    TexWord{"partial", kUpright, "∂"},
    TexWord{"nabla", kUpright, "∇"},
    TexWord{"infty", kUpright, "∞"},
    TexWord{"circ", kUpright, "°"},
    TexWord{"prime", kUpright, "′"},
    TexWord{"top", kUpright, "T"},
    TexWord{"ell", kLetter, "ℓ"},
    TexWord{"dots", kUpright, "…"},
    TexWord{"ldots", kUpright, "…"},
    TexWord{"cdots", kUpright, "⋯"},
    TexWord{"vdots", kUpright, "⋮"},
    TexWord{"vert", kUpright, "|"},
    TexWord{"lvert", kUpright, "|"},
    TexWord{"rvert", kUpright, "|"},
    TexWord{"Vert", kUpright, "‖"},
    TexWord{"lVert", kUpright, "‖"},
    TexWord{"rVert", kUpright, "‖"},
    TexWord{"|", kUpright, "‖"},
    TexWord{"langle", kUpright, "⟨"},
    TexWord{"rangle", kUpright, "⟩"},
    TexWord{"{", kUpright, "{"},
    TexWord{"}", kUpright, "}"},
    TexWord{"%", kUpright, "%"},
    TexWord{"$", kUpright, "$"},
    TexWord{"&", kUpright, "&"},
    TexWord{"_", kUpright, "_"},
    TexWord{"#", kUpright, "#"},
    TexWord{",", kSpace, "\u2009"},
    TexWord{":", kSpace, "\u2009"},
    TexWord{";", kSpace, "\u00a0"},
    TexWord{"!", kSpace, ""},
    TexWord{" ", kSpace, "\u00a0"},
    TexWord{"quad", kSpace, "\u00a0\u00a0\u00a0\u00a0"},
    TexWord{"qquad", kSpace, "\u00a0\u00a0\u00a0\u00a0\u00a0\u00a0\u00a0\u00a0"},
};

struct Accent {
  std::string_view name, mark;
};
constexpr std::array kAccents{Accent{"vec", "\u20d7"},  Accent{"hat", "\u0302"}, Accent{"dot", "\u0307"},
                              Accent{"ddot", "\u0308"}, Accent{"bar", "\u0304"}, Accent{"tilde", "\u0303"}};

}  // namespace

const TexWord* findTexWord(std::string_view name) {
  for (const TexWord& word : kWords) {
    if (word.name == name) return &word;
  }
  return nullptr;
}

std::string_view texAccent(std::string_view name) {
  for (const Accent& accent : kAccents) {
    if (accent.name == name) return accent.mark;
  }
  return {};
}

std::vector<std::string> texCommands() {
  std::vector<std::string> names{"frac", "sqrt", "mathbf", "mathrm", "text", "operatorname", "left", "right", "begin"};
  for (const TexWord& word : kWords) names.emplace_back(word.name);
  for (const Accent& accent : kAccents) names.emplace_back(accent.name);
  return names;
}

}  // namespace underact::page
