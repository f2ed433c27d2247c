// A perceptron whose gradient is written out by hand.

/** Perceptron with elu between its layers. Weights of a layer are (outputs, inputs), then its biases. */
export class Perceptron {
  /**
   * @param {number[]} sizes width of the input, of every hidden layer and of the output.
   */
  constructor(sizes) {
    this.sizes = sizes;
    this.layers = sizes.slice(1).map((outputs, i) => ({ inputs: sizes[i], outputs }));
    this.length = 0;
    for (const layer of this.layers) {
      layer.start = this.length;
      this.length += (layer.inputs + 1) * layer.outputs;
    }
    this.values = sizes.map((size) => new Float64Array(size));
    this.slopes = sizes.map((size) => new Float64Array(size));
  }

  /** Draw weights for parameters (length,): variance 1 / inputs, the last layer's smaller by `last`; biases 0. */
  initialize(parameters, random, last) {
    for (const { start, inputs, outputs } of this.layers) {
      const size = (outputs === this.sizes.at(-1) ? last : 1) / Math.sqrt(inputs);
      for (let i = 0; i < inputs * outputs; i++) parameters[start + i] = size * random.normal();
      parameters.fill(0, start + inputs * outputs, start + (inputs + 1) * outputs);
    }
  }

  /** Output for one input, which begins at `offset` of `batch`; valid until the next call. */
  forward(parameters, batch, offset = 0) {
    const first = this.values[0];
    for (let i = 0; i < first.length; i++) first[i] = batch[offset + i];
    for (let n = 0; n < this.layers.length; n++) {
      const { start, inputs, outputs } = this.layers[n], x = this.values[n], y = this.values[n + 1];
      const hidden = n + 1 < this.layers.length, biases = start + inputs * outputs;
      for (let j = 0, w = start; j < outputs; j++, w += inputs) {
        let sum = parameters[biases + j];
        for (let i = 0; i < inputs; i++) sum += parameters[w + i] * x[i];
        y[j] = hidden && sum < 0 ? Math.exp(sum) - 1 : sum;
      }
    }
    return this.values.at(-1);
  }

  /** Add the gradient of the last `forward` to `gradient` (length,), from the loss's slope by the output. */
  backward(parameters, gradient, slope) {
    this.slopes.at(-1).set(slope);
    for (let n = this.layers.length - 1; n >= 0; n--) {
      const { start, inputs, outputs } = this.layers[n], x = this.values[n], dx = this.slopes[n];
      const y = this.values[n + 1], dy = this.slopes[n + 1], biases = start + inputs * outputs;
      const hidden = n + 1 < this.layers.length;
      if (n > 0) dx.fill(0);
      for (let j = 0, w = start; j < outputs; j++, w += inputs) {
        const d = hidden && y[j] < 0 ? dy[j] * (y[j] + 1) : dy[j];  // the slope of elu is elu + 1 below 0
        gradient[biases + j] += d;
        if (n > 0) for (let i = 0; i < inputs; i++) { gradient[w + i] += d * x[i]; dx[i] += d * parameters[w + i]; }
        else for (let i = 0; i < inputs; i++) gradient[w + i] += d * x[i];
      }
    }
  }
}

/** Adam (Kingma and Ba, arXiv 1412.6980). */
export class Adam {
  constructor(parameters) {
    Object.assign(this, { parameters, steps: 0 });
    this.mean = new Float64Array(parameters.length);
    this.square = new Float64Array(parameters.length);
  }

  /** Move the parameters (n,) against a gradient, the first n numbers of an array. */
  step(gradient, rate) {
    const { parameters, mean, square } = this;
    this.steps++;
    const size = (rate * Math.sqrt(1 - 0.999 ** this.steps)) / (1 - 0.9 ** this.steps);
    for (let i = 0; i < parameters.length; i++) {
      mean[i] += 0.1 * (gradient[i] - mean[i]);
      square[i] += 0.001 * (gradient[i] * gradient[i] - square[i]);
      parameters[i] -= (size * mean[i]) / (Math.sqrt(square[i]) + 1e-8);
    }
  }
}

/** Random numbers from a seed (mulberry32), the same in every browser. */
export class Random {
  constructor(seed) { this.state = Math.imul(seed + 1, 0x9e3779b1) >>> 0; }

  /** Number in [0, 1). */
  uniform() {
    this.state = (this.state + 0x6d2b79f5) >>> 0;
    let bits = Math.imul(this.state ^ (this.state >>> 15), this.state | 1);
    bits ^= bits + Math.imul(bits ^ (bits >>> 7), bits | 61);
    return ((bits ^ (bits >>> 14)) >>> 0) / 2 ** 32;
  }

  /** Number between -size and size. */
  either(size) { return size * (2 * this.uniform() - 1); }

  /** Put an array's values in another order. */
  shuffle(values) {
    for (let i = values.length - 1; i > 0; i--) {
      const j = Math.floor((i + 1) * this.uniform());
      [values[i], values[j]] = [values[j], values[i]];
    }
  }

  /** Number of the standard normal distribution (Box and Muller). */
  normal() { return Math.sqrt(-2 * Math.log(1 - this.uniform())) * Math.cos(2 * Math.PI * this.uniform()); }
}
