/** Gives the global `Math` its own functions back once planck has taken its references. */
import { engineTrig } from './lend-exact-trig';

Math.sin = engineTrig.sin;
Math.cos = engineTrig.cos;
Math.atan2 = engineTrig.atan2;
