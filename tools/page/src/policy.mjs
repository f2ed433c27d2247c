// An exported policy's graph of ONNX operators on one env: every value is a vector, its batch axis of length 1 left out.

/** Element-wise operator of two vectors, of which one may have the length 1. */
const binary = (f) => (a, b) => {
  const out = new Float32Array(Math.max(a.length, b.length));
  const [i, j] = [a.length > 1 ? 1 : 0, b.length > 1 ? 1 : 0];
  return [out, () => { for (let k = 0; k < out.length; k++) out[k] = f(a[i * k], b[j * k]); }];
};

const unary = (f) => (a) => {
  const out = new Float32Array(a.length);
  return [out, () => { for (let k = 0; k < out.length; k++) out[k] = f(a[k]); }];
};

/** Vector (n) times matrix (n, m) by rows, plus a vector (m) for Gemm. */
const product = (a, matrix, bias) => {
  const n = a.length, m = matrix.length / n, out = new Float32Array(m), sum = new Float64Array(m);
  return [out, () => {
    if (bias) sum.set(bias); else sum.fill(0);
    for (let i = 0, k = 0; i < n; i++) {
      const x = a[i];
      for (let j = 0; j < m; j++, k++) sum[j] += x * matrix[k];
    }
    out.set(sum);
  }];
};

const sigmoid = (x) => 1 / (1 + Math.exp(-x));
const softplus = (x) => Math.max(x, 0) + Math.log1p(Math.exp(-Math.abs(x)));
/** Abramowitz and Stegun 7.1.26: within 1.5e-7. */
const erf = (x) => {
  const t = 1 / (1 + 0.3275911 * Math.abs(x));
  const series = t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
  return Math.sign(x) * (1 - series * Math.exp(-x * x));
};

/** Operator -> function of its inputs and attributes, which returns the output and the function that computes it. */
const OPERATORS = {
  Add: binary((a, b) => a + b), Sub: binary((a, b) => a - b), Mul: binary((a, b) => a * b), Div: binary((a, b) => a / b),
  Max: binary(Math.max), Min: binary(Math.min), Mod: binary((a, b) => a % b), Greater: binary((a, b) => Number(a > b)),
  Abs: unary(Math.abs), Sign: unary(Math.sign), Sqrt: unary(Math.sqrt), Sin: unary(Math.sin), Cos: unary(Math.cos),
  Tanh: unary(Math.tanh), Erf: unary(erf), Sigmoid: unary(sigmoid), Softplus: unary(softplus),
  Relu: unary((x) => Math.max(x, 0)), LeakyRelu: unary((x) => (x < 0 ? 0.01 * x : x)),
  Elu: unary((x) => (x < 0 ? Math.expm1(x) : x)),
  Selu: unary((x) => 1.0507009873554805 * (x < 0 ? 1.6732632423543772 * Math.expm1(x) : x)),
  Cast: unary((x) => x), IsNaN: unary((x) => Number(Number.isNaN(x))),
  MatMul: product, Gemm: product,
  Concat: (...parts) => {
    const out = new Float32Array(parts.reduce((length, part) => length + part.length, 0));
    return [out, () => { let at = 0; for (const part of parts) { out.set(part, at); at += part.length; } }];
  },
  Where: (condition, a, b) => {
    const out = new Float32Array(condition.length);
    return [out, () => { for (let k = 0; k < out.length; k++) out[k] = condition[k] ? a[k] : b[k]; }];
  },
  Slice: (a, [start], [end]) => {
    const out = new Float32Array(end - start);
    return [out, () => out.set(a.subarray(start, end))];
  },
};

/** Names of the operators that a graph may use. */
export const operators = Object.keys(OPERATORS);

/** Float32 numbers from base64. */
export function floats(base64) {
  return new Float32Array(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer);
}

/** A graph, ready to run: see `quadruped_env/walking_page/document.py` for its form. */
export class Graph {
  constructor({ nodes, constants, inputs, outputs }) {
    this.inputs = Object.fromEntries(Object.entries(inputs).map(([name, width]) => [name, new Float32Array(width)]));
    this.outputs = outputs;
    /** Every value by name; those of inputs and nodes change with each run. */
    this.values = { ...this.inputs };
    for (const [name, data] of Object.entries(constants)) this.values[name] = floats(data);
    this.steps = nodes.map(([operator, names, output]) => {
      const [out, compute] = OPERATORS[operator](...names.map((name) => this.values[name]));
      this.values[output] = out;
      return [compute, output, out];
    });
  }

  /**
   * Compute the outputs, which stay valid until the next run.
   * @param inputs vector of each input by name
   * @param factors number by which an inner value is multiplied, by its name
   */
  run(inputs, factors = {}) {
    for (const [name, buffer] of Object.entries(this.inputs)) buffer.set(inputs[name]);
    for (const [compute, name, out] of this.steps) {
      compute();
      if (factors[name] !== undefined) for (let k = 0; k < out.length; k++) out[k] *= factors[name];
    }
    return Object.fromEntries(this.outputs.map((name) => [name, this.values[name]]));
  }
}
