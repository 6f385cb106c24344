import type { Mover, SceneObject, Shaped } from './scene';

/** What a mover may do besides going to and fro between two places. */
const foeProperties = ['stops', 'waits', 'loops', 'phase', 'spin', 'chases'] as const;

/** What no version of the course file before 5, and no link before version 7, can say of an object. */
export interface Additions extends Pick<Mover, (typeof foeProperties)[number]> {
  /** That of older versions are eighths of a full turn. */
  readonly angle?: number;
  /** Of a body; zones have always been round or not. */
  readonly round?: true;
  readonly corners?: NonNullable<Shaped['corners']>;
  readonly lock?: true;
  readonly group?: string;
}

/** What is new of an object; empty: older versions can say all of it. */
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

/** Whether an angle in degrees is a number of eighths of a full turn. */
export const isEighth = (angleDeg: number): boolean => angleDeg % 45 === 0;
