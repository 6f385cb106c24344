import { isRecord } from '#core/record';
import { parseEdit } from '#scene/check-edit';
import type { InputEvent } from '#simulation/input';
import { MOST_DEVICES, type DeviceSetup, type RunSetup } from '#simulation/run-setup';

type Fields = Readonly<Record<string, unknown>>;
type Check = (value: unknown) => boolean;

const isText: Check = (value) => typeof value === 'string';
const isNumber: Check = (value) => typeof value === 'number' && Number.isFinite(value);
const isFlag: Check = (value) => typeof value === 'boolean';
const isPose: Check = (value) => isRecord(value) && [value.xMm, value.yMm, value.headingDeg].every(isNumber);
const isTexts: Check = (value) => isRecord(value) && Object.values(value).every(isText);
/** Numbers, and records of them, to any depth: what was measured of a robot. */
const isFigures: Check = (value) => isNumber(value) || (isRecord(value) && Object.values(value).every(isFigures));
const isStart: Check = (value) =>
  isRecord(value) &&
  (value.type === null || isText(value.type)) &&
  Array.isArray(value.at) &&
  value.at.length === 2 &&
  value.at.every(isNumber) &&
  isNumber(value.heading) &&
  isNumber(value.scale) &&
  isTexts(value.options);

/** The checks of a device's fields; those in the second table may be missing. */
const DEVICE: Readonly<Record<string, Check>> = { name: isText, files: isTexts, robot: isText, board: isText };
const OF_SOME: Readonly<Record<string, Check>> = {
  firmware: isText,
  robotOptions: isTexts,
  traits: isFigures,
  start: isStart,
};

/** The checks of an action's fields. Whether the board has what it names is checked when the run is made. */
const ACTIONS: Readonly<Record<string, Readonly<Record<string, Check>>>> = {
  button: { button: (value) => value === 'a' || value === 'b', down: isFlag },
  touch: { pad: isText, down: isFlag },
  remote: { key: isText, down: isFlag },
  stick: { x: isNumber, y: isNumber },
  gamepad: { key: isText, down: isFlag },
  serial: { text: isText },
  sensor: { id: isText, value: (value) => isText(value) || isNumber(value) },
  place: { pose: isPose },
  'place-block': { id: isText, pose: isPose },
  switch: { id: isText, on: isFlag },
  radio: {},
  'arena-senses': { on: isFlag },
  edit: { edit: (value) => 'edit' in parseEdit(value) },
  interrupt: {},
};
const isPacket = ({ text, bytes }: Fields): boolean => isText(text) || (Array.isArray(bytes) && bytes.every(isNumber));

/** The end of every message on a recording: nobody writes one by hand. */
const DAMAGED = '; the recording is damaged';

/** @throws TypeError with a sentence that names the place and the value, and ends with `way` */
function check(
  fields: Fields,
  checks: Readonly<Record<string, Check>>,
  place: string,
  { mayMiss = false, way = DAMAGED } = {},
): void {
  for (const [name, isRight] of Object.entries(checks)) {
    const value = fields[name];
    if ((mayMiss && value === undefined) || isRight(value)) continue;
    const found = (JSON.stringify(value) ?? 'nothing').slice(0, 60);
    throw new TypeError(`${place}.${name}: ${found} does not belong here${way}.`);
  }
}

/** @throws TypeError with a sentence for what no device is like */
export function readDevices(value: unknown): RunSetup['devices'] {
  if (!Array.isArray(value) || value.length === 0 || value.length > MOST_DEVICES)
    throw new TypeError(`setup.devices: must be a list of one to ${MOST_DEVICES}; the recording is damaged.`);
  for (const [index, device] of value.entries()) {
    if (!isRecord(device)) throw new TypeError(`setup.devices[${index}]: is no device; the recording is damaged.`);
    check(device, DEVICE, `setup.devices[${index}]`);
    check(device, OF_SOME, `setup.devices[${index}]`, { mayMiss: true });
  }
  return value as unknown as [DeviceSetup];
}

/**
 * Reads inputs with their times in µs.
 *
 * @param at where they stand in the file
 * @param way what the sentence ends with: what is wrong with the file, or what helps
 * @throws TypeError with a sentence for what no input is like
 */
export function readInputs(value: unknown, at = 'setup.inputs', way = DAMAGED): readonly InputEvent[] {
  if (!Array.isArray(value)) throw new TypeError(`${at}: must be a list${way}.`);
  for (const [index, event] of value.entries()) {
    const place = `${at}[${index}]`;
    const { action } = isRecord(event) ? event : {};
    if (!isRecord(event) || !isRecord(action)) throw new TypeError(`${place}: is no input${way}.`);
    check(event, { timeUs: isNumber }, place, { way });
    check(event, { device: isText }, place, { mayMiss: true, way });
    check(action, { type: (type) => isText(type) && Object.hasOwn(ACTIONS, String(type)) }, `${place}.action`, { way });
    check(action, ACTIONS[String(action.type)] ?? {}, `${place}.action`, { way });
    if (action.type === 'radio' && !isPacket(action)) throw new TypeError(`${place}.action: has no packet${way}.`);
  }
  return value as InputEvent[];
}
