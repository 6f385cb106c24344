import type { RunSetup } from '#simulation/run-setup';
import { faultsOf } from '#simulation/reality';
import type { LabRun } from './lab-model';

/** A lasting difference of a used robot, for its words. */
export type Fault =
  | { readonly kind: 'pulls'; readonly to: 'left' | 'right'; readonly isHard: boolean }
  | { readonly kind: 'weaker'; readonly percent: number }
  /** A line sensor sees the floor otherwise than it is. */
  | { readonly kind: 'sees'; readonly side: 'left' | 'middle' | 'right'; readonly isLighter: boolean }
  /** A robot that was measured is always the same one: only chance differs. */
  | { readonly kind: 'trembles' };

/** From this share of difference between the motors on a robot pulls hard. Chosen: half of the robots. */
const HARD = 0.045;
/** From this reflectance on a sensor that sees otherwise is worth a word. Chosen: half of the largest. */
const WORTH = 0.04;
/** From this on a weak battery is worth a word, in per cent. */
const WEAK = 2;
/** A sensor less far from the middle than this is in the middle, in mm. */
const MIDDLE_MM = 2;

/** The lasting faults of the used robot of a run, the ones that matter most first. */
export function faultsIn({ setup, drive }: { readonly setup: RunSetup } & Pick<LabRun, 'drive'>): readonly Fault[] {
  const { reality, seed, scene, devices } = setup;
  if (reality === 0) return [];
  if (devices[0].traits !== undefined) return [{ kind: 'trembles' }];
  const { motors, lighter } = faultsOf(reality, seed);
  const { difference, charge } = motors;
  const percent = Math.round(100 * (1 - charge));
  const scale = scene.robot.scale ?? 1;
  const seen = (drive?.lineMm ?? []).map(({ x, y }) => ({ y, by: lighter({ x: x * scale, y: y * scale }) }));
  const [worst] = seen.toSorted((one, other) => Math.abs(other.by) - Math.abs(one.by));
  return [
    // The stronger motor drives its side ahead: the robot turns to the other one.
    { kind: 'pulls', to: difference > 0 ? 'right' : 'left', isHard: Math.abs(difference) > reality * HARD },
    ...(percent < WEAK ? [] : [{ kind: 'weaker', percent } as const]),
    ...(worst === undefined || Math.abs(worst.by) < reality * WORTH
      ? []
      : [{ kind: 'sees', side: sideOf(worst.y), isLighter: worst.by > 0 } as const]),
  ];
}

const sideOf = (yMm: number): 'left' | 'middle' | 'right' =>
  Math.abs(yMm) < MIDDLE_MM ? 'middle' : yMm > 0 ? 'left' : 'right';
