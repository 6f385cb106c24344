/**
 * Replaces the browser's sine, cosine and arc tangent by the exact ones while the physics engine is loaded: planck
 * takes its own references to `Math.sin`, `Math.cos` and `Math.atan2` once, when its module is evaluated. Must be
 * imported before planck, and `./return-exact-trig` after it.
 */
import { exactAtan2, exactCos, exactSin } from '#core/exact-math';

/** The browser's own functions, to be put back. */
export const engineTrig = { sin: Math.sin, cos: Math.cos, atan2: Math.atan2 };

Math.sin = exactSin;
Math.cos = exactCos;
Math.atan2 = exactAtan2;
