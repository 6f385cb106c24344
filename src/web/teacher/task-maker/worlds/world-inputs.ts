import { sensorInfos, type RangeInfo } from '../../../pupil/board/panels/sensor-list';
import type { InputAction, InputEvent } from '#simulation/input';

/** Sensors that can be set, besides pins, which are pressed. */
export const worldSensors: readonly RangeInfo[] = sensorInfos.flatMap((info) =>
  info.kind === 'range' && !/^(?:pin|button|compass[XYZ])/.test(info.id) ? [info] : [],
);

/** The gestures that a board can be made to feel. */
export const worldGestures: readonly string[] = sensorInfos.flatMap((info) =>
  info.kind === 'choice' ? info.choices.filter((choice) => choice !== info.start) : [],
);

/** The events of a world: a press, which lasts, or an event of one moment, with a value. */
export const inputKinds = [
  ...(['button a', 'button b', 'touch pinLogo', 'touch pin0', 'touch pin1', 'touch pin2'] as const),
  ...(['gesture', 'radio', 'serial'] as const),
  ...worldSensors.map(({ id }) => `sensor ${id}` as const),
];
export type InputKind = (typeof inputKinds)[number];

/** An event as a row of the form. */
export interface InputRow {
  /** Indexes of its events among all of the world. */
  readonly places: readonly number[];
  readonly kind: InputKind;
  readonly atUs: number;
  /** Duration of a press; `null`: until the end, or it is none. */
  readonly heldUs: number | null;
  /** `null`: a press has none. */
  readonly value: number | string | null;
}

export const isPress = (kind: InputKind): boolean => kind.startsWith('button') || kind.startsWith('touch');

/** Duration of a new press. Chosen: a quick finger. */
const PRESS_US = 200_000;

/** A new event of this kind, with initial values. */
export function freshInput(kind: InputKind, atUs: number): Omit<InputRow, 'places'> {
  if (isPress(kind)) return { kind, atUs, heldUs: PRESS_US, value: null };
  const info = worldSensors.find(({ id }) => kind === `sensor ${id}`);
  return { kind, atUs, heldUs: null, value: info?.start ?? (kind === 'gesture' ? 'shake' : '') };
}

/** The events of a world, as far as the page can show them; the others come from a file and are kept. */
export function inputRows(inputs: readonly InputEvent[]): readonly InputRow[] {
  const taken = new Set<number>();
  return inputs.flatMap(({ timeUs: atUs, device, action }, place): readonly InputRow[] => {
    const found = device === undefined ? kindOf(action) : null;
    if (found === null || taken.has(place)) return [];
    if (!isPress(found.kind)) return [{ places: [place], atUs, heldUs: null, ...found }];
    if (!isDown(action)) return [];
    const end = inputs.findIndex(
      (event, at) =>
        at > place && event.device === undefined && kindOf(event.action)?.kind === found.kind && !taken.has(at),
    );
    const release = inputs[end];
    if (release === undefined || isDown(release.action)) return [{ places: [place], atUs, heldUs: null, ...found }];
    taken.add(end);
    return [{ places: [place, end], atUs, heldUs: release.timeUs - atUs, ...found }];
  });
}

const isDown = (action: InputAction): boolean => 'down' in action && action.down;

function kindOf(action: InputAction): Pick<InputRow, 'kind' | 'value'> | null {
  switch (action.type) {
    case 'button':
      return { kind: `button ${action.button}`, value: null };
    case 'touch':
      return known(`touch ${action.pad}`, null);
    case 'serial':
      return { kind: 'serial', value: action.text.replace(/\r$/, '') };
    case 'radio':
      return 'text' in action ? { kind: 'radio', value: action.text } : null;
    case 'sensor':
      return known(action.id === 'gesture' ? 'gesture' : `sensor ${action.id}`, action.value);
    default:
      return null;
  }
}

function known(name: string, value: InputRow['value']): Pick<InputRow, 'kind' | 'value'> | null {
  const kind = inputKinds.find((one) => one === name);
  return kind === undefined ? null : { kind, value };
}

/** The inputs with a row changed, added (without places) or taken away (`null`), in the order of their times. */
export function withInput(
  inputs: readonly InputEvent[],
  places: readonly number[],
  row: Omit<InputRow, 'places'> | null,
): readonly InputEvent[] {
  const others = inputs.filter((_, place) => !places.includes(place));
  const made = row === null ? [] : eventsOf(row);
  return [...others, ...made].sort((one, other) => one.timeUs - other.timeUs);
}

function eventsOf({ kind, atUs, heldUs, value }: Omit<InputRow, 'places'>): readonly InputEvent[] {
  const [type, name = ''] = kind.split(' ');
  const at = (timeUs: number, action: InputAction): InputEvent => ({ timeUs, action });
  switch (type) {
    case 'radio':
      return [at(atUs, { type, text: String(value) })];
    case 'serial':
      return [at(atUs, { type, text: `${String(value)}\r` })];
    case 'gesture':
      return [at(atUs, { type: 'sensor', id: 'gesture', value: String(value) })];
    case 'sensor':
      return [at(atUs, { type, id: name, value: value ?? 0 })];
    default: {
      const press = (down: boolean): InputAction =>
        type === 'button' ? { type, button: name === 'a' ? 'a' : 'b', down } : { type: 'touch', pad: name, down };
      return [at(atUs, press(true)), ...(heldUs === null ? [] : [at(atUs + heldUs, press(false))])];
    }
  }
}
