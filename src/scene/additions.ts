import type { Mover, SceneObject, Shaped } from './scene';

/** The properties of movers beyond a path between two places. */
const foeProperties = ['stops', 'waits', 'loops', 'phase', 'spin', 'chases'] as const;

/** The properties of an object that no course file before version 5, and no link before version 7, can hold. */
export interface Additions extends Pick<Mover, (typeof foeProperties)[number]> {
  /** Only if it is no multiple of 45°: older versions count in eighths of a full turn. */
  readonly angle?: number;
  /** True for a round body; zones have always had `round`. */
  readonly round?: true;
  readonly corners?: NonNullable<Shaped['corners']>;
  readonly lock?: true;
  readonly group?: string;
}

/** The additions of an object; empty if older versions can hold all of it. */
export function additionsOf(object: SceneObject): Additions {
  const { lock, group } = object;
  const corners = 'corners' in object ? object.corners : undefined;
  return {
    ...('angle' in object && !isEighth(object.angle) ? { angle: object.angle } : {}),
    ...('round' in object && object.round && !('number' in object) ? { round: true } : {}),
    ...(corners === undefined ? {} : { corners }),
    ...(lock === undefined ? {} : { lock }),
    ...(group === undefined ? {} : { group }),
    ...(object.type === 'mover' ? foeOf(object) : {}),
  };
}

const foeOf = (mover: Mover): Pick<Mover, (typeof foeProperties)[number]> =>
  Object.fromEntries(foeProperties.flatMap((name) => (mover[name] === undefined ? [] : [[name, mover[name]]])));

/** True if an angle is a multiple of 45°, an eighth of a full turn. */
export const isEighth = (angleDeg: number): boolean => angleDeg % 45 === 0;
