import { freeId } from '#check/task/read-checks';
import { lightColors, lightPlaces, taskLimits, USUAL_WITHIN_DEG, type Check, type CheckKind } from '#check/task/task';
import { blocksOf, zonesOf } from '#check/task/named-objects';
import { sceneLimits, type Scene } from '#scene/scene';

/** A field of a check's form, besides points and whether the check is needed. */
export type CheckField =
  | {
      readonly kind: 'number';
      readonly name: FieldName;
      readonly unit: string;
      readonly min: number;
      readonly max: number;
      readonly decimals: number;
      /** May stay empty. */
      readonly isOptional: boolean;
    }
  | { readonly kind: 'text'; readonly name: FieldName; readonly most: number; readonly isOptional: boolean }
  /** The 25 LEDs of the display. */
  | { readonly kind: 'picture'; readonly name: 'image' }
  /** A zone of the course; `none`: the word for no certain one, `null`: there must be one. */
  | { readonly kind: 'zone'; readonly name: 'zone'; readonly none: 'anyTarget' | 'anyFloor' | null }
  /** Several zones of the course. */
  | { readonly kind: 'zones'; readonly name: 'zones' }
  /** A movable block of the course. */
  | { readonly kind: 'object'; readonly name: 'object' }
  | { readonly kind: 'flag'; readonly name: 'whole' }
  | { readonly kind: 'place'; readonly name: 'which'; readonly choices: typeof lightPlaces }
  /** May stay empty. */
  | { readonly kind: 'color'; readonly name: 'color'; readonly choices: typeof lightColors };

/** The names of fields, as the checks of a task have them. */
export type FieldName =
  | ('seconds' | 'count' | 'most' | 'hz' | 'text' | 'rows' | 'column' | 'name')
  | ('heading' | 'within' | 'each' | 'percent' | 'least');

const number = (
  name: FieldName,
  { min, max }: { readonly min: number; readonly max: number },
  more: { readonly unit?: string; readonly decimals?: number; readonly isOptional?: boolean } = {},
): CheckField => ({ kind: 'number', name, min, max, unit: '', decimals: 0, isOptional: false, ...more });

const text = (name: FieldName, isOptional = false): CheckField => ({
  ...{ kind: 'text', name, isOptional },
  most: taskLimits.textCharacters,
});

const seconds = number('seconds', { min: 0.1, max: taskLimits.seconds.max }, { unit: 's', decimals: 1 });

const zone = (none: 'anyTarget' | 'anyFloor' | null): CheckField => ({ kind: 'zone', name: 'zone', none });

/** The form of each type of check. */
export const fieldsOf: Readonly<Record<CheckKind['type'], readonly CheckField[]>> = {
  goals: [],
  reach: [{ kind: 'zones', name: 'zones' }],
  stop: [
    seconds,
    zone('anyTarget'),
    { kind: 'flag', name: 'whole' },
    number('heading', sceneLimits.headingDeg, { unit: '°', isOptional: true }),
    number('within', taskLimits.withinDeg, { unit: '°' }),
  ],
  stay: [seconds, zone('anyTarget')],
  laps: [number('count', taskLimits.laps)],
  checkpoints: [number('each', taskLimits.points, { isOptional: true })],
  belongs: [{ kind: 'object', name: 'object' }, zone(null)],
  covered: [number('percent', taskLimits.percent, { unit: '%' }), zone('anyFloor')],
  tiles: [number('count', taskLimits.tiles)],
  score: [number('least', taskLimits.score)],
  touches: [number('most', taskLimits.touches)],
  faster: [seconds],
  later: [seconds],
  display: [{ kind: 'picture', name: 'image' }],
  light: [
    { kind: 'place', name: 'which', choices: lightPlaces },
    { kind: 'color', name: 'color', choices: lightColors },
  ],
  sound: [number('hz', taskLimits.hz, { unit: 'Hz', isOptional: true })],
  console: [text('text')],
  radio: [text('text')],
  log: [number('rows', taskLimits.rows), text('column', true)],
  loop: [],
  calls: [text('name')],
  lines: [number('most', taskLimits.lines)],
  delay: [number('most', taskLimits.delayMs, { unit: 'ms' })],
};

/** The initial values of each check. */
const fresh: { readonly [T in CheckKind['type']]: Extract<CheckKind, { readonly type: T }> } = {
  goals: { type: 'goals' },
  reach: { type: 'reach', zones: [] },
  stop: { type: 'stop', seconds: 2, zone: null, whole: false, heading: null, within: USUAL_WITHIN_DEG },
  stay: { type: 'stay', seconds: 5, zone: null },
  laps: { type: 'laps', count: 2 },
  checkpoints: { type: 'checkpoints', each: null },
  belongs: { type: 'belongs', object: '', zone: '' },
  covered: { type: 'covered', percent: 80, zone: null },
  tiles: { type: 'tiles', count: 5 },
  score: { type: 'score', least: 50 },
  touches: { type: 'touches', most: 0 },
  faster: { type: 'faster', seconds: 30 },
  later: { type: 'later', seconds: 10 },
  display: { type: 'display', image: '09090:99999:99999:09990:00900' },
  light: { type: 'light', which: 'any', color: null },
  sound: { type: 'sound', hz: null },
  console: { type: 'console', text: 'OK' },
  radio: { type: 'radio', text: 'OK' },
  log: { type: 'log', rows: 10, column: '' },
  loop: { type: 'loop' },
  calls: { type: 'calls', name: 'irLeft' },
  lines: { type: 'lines', most: 15 },
  delay: { type: 'delay', most: 2000 },
};

/** True if the course has what a type of check asks about. */
export function canBeAsked(type: CheckKind['type'], scene: Scene): boolean {
  if (type === 'tiles' || type === 'score') return scene.league !== undefined;
  return type !== 'belongs' || (blocksOf(scene).length > 0 && zonesOf(scene).length > 0);
}

/** A new check, with an id of its own; one that names things begins with the first of the course. */
export function freshCheck(type: CheckKind['type'], others: readonly Check[], scene: Scene): Check {
  const kind = fresh[type];
  const [[object = ''], [first = '']] = [blocksOf(scene), zonesOf(scene)];
  const named = kind.type === 'belongs' ? { ...kind, object, zone: first } : kind;
  return { ...named, id: freeId(type, others), points: 1, needed: true };
}
