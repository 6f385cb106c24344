import { DRIVES, type Drive, type Measured } from './my-robot';
import type { Motion } from './predict';

/** Mean distance in mm between where the noses were measured and where they are; `null` without a measured drive. */
export function missMm(measured: Measured, motion: Motion): number | null {
  const all = DRIVES.flatMap((name) => {
    const real = measured.drives[name];
    const here = motion.drives[name];
    return real === null ? [] : [distance(here, real)];
  });
  return all.length === 0 ? null : all.reduce((sum, mm) => sum + mm, 0) / all.length;
}

function distance(one: Drive, other: Drive): number {
  const [ahead, left] = [one.aheadMm - other.aheadMm, one.leftMm - other.leftMm];
  return Math.sqrt(ahead * ahead + left * left);
}
