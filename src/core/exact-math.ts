/**
 * Trigonometry that gives the same bits in every engine; the exponential and the logarithm are in `exact-exp.ts`.
 * `Math.sin` and its kin differ from browser to browser; these use only + − × ÷ and `Math.sqrt`, which IEEE 754 fixes.
 * Method and coefficients: fdlibm 5.3; results are within 1 ulp of the true value.
 * @license fdlibm (mathematical functions): Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved. Developed
 * at SunPro, a Sun Microsystems, Inc. business. Permission to use, copy, modify, and distribute this software is freely
 * granted, provided that this notice is preserved.
 */

const TWO_OVER_PI = 6.36619772367581382433e-1;
// π/2 in three pieces of 33 bits and what is left after each (fdlibm e_rem_pio2.c).
const HALF_PI_1 = 1.57079632673412561417;
const HALF_PI_1_REST = 6.07710050650619224932e-11;
const HALF_PI_2 = 6.0771005063039660117e-11;
const HALF_PI_2_REST = 2.02226624879595063154e-21;
const HALF_PI_3 = 2.0222662487111664558e-21;
const HALF_PI_3_REST = 8.47842766036889956997e-32;
/** Beyond this many rad the reduction by three pieces of π/2 is no longer exact. */
const MAX_ANGLE = 823549;

const PI = 3.141592653589793116;
const PI_REST = 1.2246467991473531772e-16;
const HALF_PI = 1.570796326794896558;
const HALF_PI_REST = 6.12323399573676603587e-17;
/** 2⁶⁰: steeper slopes are vertical to the last bit. */
const STEEP = 1152921504606846976;

// Result of reduce(): the angle within ±π/4 as head and rest. Stored outside to save an object per call.
let reducedHead = 0;
let reducedRest = 0;

/** Takes multiples of π/2 off an angle; returns how many, modulo 4. */
function reduce(x: number): number {
  const turns = Math.floor(x * TWO_OVER_PI + 0.5);
  let head = x - turns * HALF_PI_1;
  let rest = turns * HALF_PI_1_REST;
  const size = Math.abs(x);
  if (Math.abs(head - rest) < size * 1.52587890625e-5) {
    // 2⁻¹⁶: bits were lost, take the second piece
    let before = head;
    rest = turns * HALF_PI_2;
    head = before - rest;
    rest = turns * HALF_PI_2_REST - (before - head - rest);
    if (Math.abs(head - rest) < size * 1.7763568394002505e-15) {
      // 2⁻⁴⁹: and the third
      before = head;
      rest = turns * HALF_PI_3;
      head = before - rest;
      rest = turns * HALF_PI_3_REST - (before - head - rest);
    }
  }
  reducedHead = head - rest;
  reducedRest = head - reducedHead - rest;
  return turns & 3;
}

/** Sine within ±π/4 (fdlibm k_sin.c). */
function sineKernel(x: number, rest: number): number {
  const z = x * x;
  const v = z * x;
  const r =
    8.33333333332248946124e-3 +
    z *
      (-1.98412698298579493134e-4 +
        z * (2.75573137070700676789e-6 + z * (-2.50507602534068634195e-8 + z * 1.58969099521155010221e-10)));
  return x - (z * (0.5 * rest - v * r) - rest - v * -1.66666666666666324348e-1);
}

/** Cosine within ±π/4 (fdlibm k_cos.c). */
function cosineKernel(x: number, rest: number): number {
  const z = x * x;
  const r =
    z *
    (4.16666666666666019037e-2 +
      z *
        (-1.38888888888741095749e-3 +
          z *
            (2.48015872894767294178e-5 +
              z * (-2.75573143513906633035e-7 + z * (2.0875723212981748279e-9 + z * -1.13596475577881948265e-11)))));
  const half = 0.5 * z;
  const w = 1 - half;
  return w + (1 - w - half + (z * r - x * rest));
}

/** Sine of an angle in rad; NaN beyond ±823 549 rad. */
export function exactSin(angleRad: number): number {
  const size = Math.abs(angleRad);
  if (size < 1.4901161193847656e-8) return angleRad;
  if (size < 0.785398163397448) return sineKernel(angleRad, 0);
  if (!(size <= MAX_ANGLE)) return NaN;
  const quarter = reduce(angleRad);
  if (quarter === 0) return sineKernel(reducedHead, reducedRest);
  if (quarter === 1) return cosineKernel(reducedHead, reducedRest);
  if (quarter === 2) return -sineKernel(reducedHead, reducedRest);
  return -cosineKernel(reducedHead, reducedRest);
}

/** Cosine of an angle in rad; NaN beyond ±823 549 rad. */
export function exactCos(angleRad: number): number {
  const size = Math.abs(angleRad);
  if (size < 0.785398163397448) return cosineKernel(angleRad, 0);
  if (!(size <= MAX_ANGLE)) return NaN;
  const quarter = reduce(angleRad);
  if (quarter === 0) return cosineKernel(reducedHead, reducedRest);
  if (quarter === 1) return -sineKernel(reducedHead, reducedRest);
  if (quarter === 2) return -cosineKernel(reducedHead, reducedRest);
  return sineKernel(reducedHead, reducedRest);
}

/** Tangent of an angle in rad; NaN beyond ±823 549 rad. Within 2 ulp, as the quotient of sine and cosine. */
export function exactTan(angleRad: number): number {
  return exactSin(angleRad) / exactCos(angleRad);
}

/** Arc tangent in rad, −π/2 … π/2 (fdlibm s_atan.c). */
export function exactAtan(x: number): number {
  const size = Math.abs(x);
  if (!(size < 7.378697629483821e19)) {
    if (x !== x) return NaN;
    return x > 0 ? HALF_PI : -HALF_PI;
  }
  if (size < 1.862645149230957e-9) return x;
  let reducedX = size;
  let baseHigh = 0;
  let baseLow = 0;
  if (size >= 2.4375) {
    reducedX = -1 / size;
    baseHigh = HALF_PI;
    baseLow = HALF_PI_REST;
  } else if (size >= 1.1875) {
    reducedX = (size - 1.5) / (1 + 1.5 * size);
    baseHigh = 9.82793723247329054082e-1; // atan 1.5
    baseLow = 1.39033110312309984516e-17;
  } else if (size >= 0.6875) {
    reducedX = (size - 1) / (size + 1);
    baseHigh = 7.85398163397448278999e-1; // atan 1
    baseLow = 3.06161699786838301793e-17;
  } else if (size >= 0.4375) {
    reducedX = (2 * size - 1) / (2 + size);
    baseHigh = 4.63647609000806093515e-1; // atan 0.5
    baseLow = 2.26987774529616870924e-17;
  }
  const correction = reducedX * atanSeries(reducedX * reducedX);
  const result = baseHigh === 0 ? reducedX - correction : baseHigh - (correction - baseLow - reducedX);
  return x < 0 ? -result : result;
}

/** (x − atan x) / x for small x, given x². */
function atanSeries(z: number): number {
  const w = z * z;
  const odd =
    z *
    (3.33333333333329318027e-1 +
      w *
        (1.42857142725034663711e-1 +
          w *
            (9.09088713343650656196e-2 +
              w * (6.66107313738753120669e-2 + w * (4.97687799461593236017e-2 + w * 1.62858201153657823623e-2)))));
  const even =
    w *
    (-1.99999999998764832476e-1 +
      w *
        (-1.1111110405462355788e-1 +
          w * (-7.69187620504482999495e-2 + w * (-5.83357013379057348645e-2 + w * -3.6531572744216915527e-2))));
  return odd + even;
}

/** Direction of the point (x, y) in rad, −π … π, counter-clockwise from +x; like `Math.atan2` for zeros and infinities. */
export function exactAtan2(y: number, x: number): number {
  if (x !== x || y !== y) return NaN;
  const leftward = x < 0 || (x === 0 && 1 / x < 0);
  const downward = y < 0 || (y === 0 && 1 / y < 0);
  let angle: number;
  if (y === 0) angle = leftward ? PI : 0;
  else if (x === 0) angle = HALF_PI;
  else {
    const bothInfinite = Math.abs(x) === Infinity && Math.abs(y) === Infinity;
    const slope = bothInfinite ? 1 : Math.abs(y / x);
    angle = slope > STEEP ? HALF_PI : exactAtan(slope);
    if (leftward && slope <= STEEP) angle = PI - (angle - PI_REST);
  }
  return downward ? -angle : angle;
}

/** (asin x − x) / x for |x| ≤ 0.5, given x². */
function asinSeries(z: number): number {
  const p =
    z *
    (1.66666666666666657415e-1 +
      z *
        (-3.25565818622400915405e-1 +
          z *
            (2.01212532134862925881e-1 +
              z * (-4.00555345006794114027e-2 + z * (7.91534994289814532176e-4 + z * 3.4793310759602116757e-5)))));
  const q =
    1 +
    z *
      (-2.40339491173441421878 +
        z * (2.02094576023350569471 + z * (-6.8828397160545329303e-1 + z * 7.70381505559019352791e-2)));
  return p / q;
}

/** Arc cosine in rad, 0 … π; NaN outside −1 … 1 (fdlibm e_acos.c). */
export function exactAcos(x: number): number {
  if (!(x >= -1 && x <= 1)) return NaN;
  if (x === 1) return 0;
  if (x === -1) return PI;
  if (Math.abs(x) < 0.5) return HALF_PI - (x - (HALF_PI_REST - x * asinSeries(x * x)));
  if (x < 0) {
    const z = (1 + x) * 0.5;
    const s = Math.sqrt(z);
    return PI - 2 * (s + (asinSeries(z) * s - HALF_PI_REST));
  }
  const z = (1 - x) * 0.5;
  const s = Math.sqrt(z);
  const head = Math.fround(s); // 24 bits, so that head² is exact
  const rest = (z - head * head) / (s + head);
  return 2 * (head + (asinSeries(z) * s + rest));
}

/** Arc sine in rad, −π/2 … π/2; NaN outside −1 … 1 (fdlibm e_asin.c). */
export function exactAsin(x: number): number {
  const size = Math.abs(x);
  if (!(size <= 1)) return NaN;
  if (size < 0.5) return size < 7.450580596923828e-9 ? x : x + x * asinSeries(x * x);
  const z = (1 - size) * 0.5;
  const s = Math.sqrt(z);
  const series = asinSeries(z);
  let result: number;
  if (size >= 0.975) {
    result = HALF_PI - (2 * (s + s * series) - HALF_PI_REST);
  } else {
    const head = Math.fround(s);
    const rest = (z - head * head) / (s + head);
    const p = 2 * s * series - (HALF_PI_REST - 2 * rest);
    const q = 0.5 * HALF_PI - 2 * head;
    result = 0.5 * HALF_PI - (p - q);
  }
  return x < 0 ? -result : result;
}
