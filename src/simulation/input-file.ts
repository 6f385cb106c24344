import { isGamepadKey, gamepadKeys } from '#devices/gamepad';
import { isRemoteKey, remoteKeys } from '#devices/nec-remote';
import { parseEdit } from '#scene/check-edit';
import type { InputAction, InputEvent, PlacedPose } from '#simulation/input';
import { parseDuration } from '#core/duration';

/** The actions of an input file in its own order, or a problem that names entry and field. */
export type ParsedInputs = { readonly inputs: readonly InputEvent[] } | { readonly problem: string };

/** Maximum number of entries. Chosen: an hour of moving the hand tool makes fewer. */
const MAX_ENTRIES = 100_000;

type Fields = Readonly<Record<string, unknown>>;

/** The fault of one field, for `Entry.fail`. */
interface Bad {
  readonly field: string;
  readonly problem: string;
}

/** Reads an `--input` file. Facts that only the board knows (sensors, ranges) are checked when the run is made. */
export function parseInputs(text: string): ParsedInputs {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch (error) {
    return { problem: `is not JSON: ${error instanceof Error ? error.message : String(error)}` };
  }
  if (!Array.isArray(value))
    return { problem: 'must be a list [ … ] of entries such as { "at": "1s", "button": "a", "down": true }.' };
  if (value.length > MAX_ENTRIES) return { problem: `has ${value.length} entries; the limit is ${MAX_ENTRIES}.` };
  const inputs: InputEvent[] = [];
  const releases: InputEvent[] = [];
  for (const [index, entry] of value.entries()) {
    const read = readEntry(entry);
    if ('problem' in read)
      return { problem: `[${index}]${read.field === '' ? '' : `.${read.field}`}: ${read.problem}` };
    inputs.push(read.event);
    if (read.release) releases.push(read.release);
  }
  // Behind all entries: the places that a run names in its problems are then those of the file.
  return { inputs: [...inputs, ...releases] };
}

/** An entry as what happens at its time, and the end of a press that has a duration. */
interface ReadEntry {
  readonly event: InputEvent;
  readonly release: InputEvent | null;
}

function readEntry(entry: unknown): ReadEntry | Bad {
  if (!isObject(entry)) return { field: '', problem: `must be an object { … }, not ${JSON.stringify(entry)}.` };
  if (typeof entry.at !== 'string') {
    return {
      field: 'at',
      problem: `must be a time in quotes such as "1s", not ${JSON.stringify(entry.at) ?? 'nothing'}.`,
    };
  }
  const at = parseDuration(entry.at);
  if ('problem' in at) return { field: 'at', problem: at.problem };
  const kinds = Object.keys(readers).filter((kind) => kind in entry);
  const [kind = ''] = kinds;
  const reader = readers[kind];
  if (!reader || kinds.length > 1) {
    const found = kinds.length > 1 ? `both ${kinds.join(' and ')}` : 'none of them';
    return { field: '', problem: `must have one of ${Object.keys(readers).join(', ')}; it has ${found}.` };
  }
  const { fields, read } = reader;
  const known = ['at', 'device', kind, ...fields];
  const strange = Object.keys(entry).find((key) => !known.includes(key));
  if (strange !== undefined)
    return { field: strange.slice(0, 40), problem: `is unknown here. Known: ${known.join(', ')}.` };
  const { device } = entry;
  if (device !== undefined && typeof device !== 'string')
    return wrong('device', 'the name of a device in quotes', device);
  const held = heldUs(kind, entry);
  if (typeof held === 'object' && held !== null) return held;
  const action = read(held === null ? entry : { ...entry, down: true });
  if ('problem' in action) return action;
  const whose = device !== undefined && { device };
  const event = { timeUs: at.us, ...whose, action };
  if (held === null || !('down' in action)) return { event, release: null };
  // Just before the step at which it takes effect, so that a press at that step comes after it.
  return { event, release: { timeUs: at.us + held - 1, ...whose, action: { ...action, down: false } } };
}

/** Duration of a press on the remote control that names none. Chosen: a finger's, long enough for a repeat frame. */
const KEY_US = 200_000;

/** Duration of a press in µs; `null`: the entry says `down`, or is none. */
function heldUs(kind: string, { for: text, down }: Fields): number | Bad | null {
  if (text === undefined) return kind === 'remote' && down === undefined ? KEY_US : null;
  if (down !== undefined) return { field: 'for', problem: 'does not go with down: a press has the one or the other.' };
  if (typeof text !== 'string') return wrong('for', 'a duration in quotes such as "0.5s"', text);
  const duration = parseDuration(text);
  if ('problem' in duration) return { field: 'for', problem: duration.problem };
  return duration.us > 0 ? duration.us : wrong('for', 'longer than nothing, such as "0.5s"', text);
}

/** The pads of all boards together; whether the run's board has a pad is checked when the run is made. */
const touchPads = ['pinLogo', 'pin0', 'pin1', 'pin2', 'pin3'];

/** The longest packet that radio.config allows: micropython-microbit-v2 modradio.c. */
const MAX_PACKET_BYTES = 251;

type ReadAction = (entry: Fields) => InputAction | Bad;

/** How to read each kind of entry, and which further fields it has. */
const readers: Readonly<Record<string, { readonly fields: readonly string[]; readonly read: ReadAction }>> = {
  button: { fields: ['down', 'for'], read: readButton },
  touch: { fields: ['down', 'for'], read: readTouch },
  remote: { fields: ['down', 'for'], read: readRemote },
  stick: { fields: [], read: readStick },
  gamepad: { fields: ['down', 'for'], read: readGamepad },
  serial: { fields: [], read: readSerial },
  sensor: { fields: ['value'], read: readSensor },
  place: { fields: [], read: readPlace },
  placeBlock: { fields: [], read: readPlaceBlock },
  noProgress: { fields: [], read: readNoProgress },
  lamp: { fields: ['on'], read: readLamp },
  barrier: { fields: ['open'], read: readBarrier },
  interrupt: { fields: [], read: readInterrupt },
  radio: { fields: [], read: readRadio },
  arenaSenses: { fields: [], read: readArenaSenses },
  edit: { fields: [], read: readEdit },
};

function readButton(entry: Fields): InputAction | Bad {
  const { button, down } = entry;
  if (button !== 'a' && button !== 'b') return wrong('button', '"a" or "b"', button);
  if (typeof down !== 'boolean') return wrong('down', 'true or false', down);
  return { type: 'button', button, down };
}

function readTouch(entry: Fields): InputAction | Bad {
  const { touch, down } = entry;
  if (typeof touch !== 'string' || !touchPads.includes(touch))
    return wrong('touch', `one of ${touchPads.join(', ')}`, touch);
  if (typeof down !== 'boolean') return wrong('down', 'true or false', down);
  return { type: 'touch', pad: touch, down };
}

const remoteNames = remoteKeys.map(([name]) => name).join(', ');

function readRemote({ remote, down }: Fields): InputAction | Bad {
  if (!isRemoteKey(remote)) return wrong('remote', `a key in quotes, one of ${remoteNames}`, remote);
  if (typeof down !== 'boolean') return wrong('down', 'true or false', down);
  return { type: 'remote', key: remote, down };
}

function readStick({ stick }: Fields): InputAction | Bad {
  if (!isObject(stick)) return wrong('stick', 'an object { "x": …, "y": … }', stick);
  const strange = Object.keys(stick).find((key) => key !== 'x' && key !== 'y');
  if (strange !== undefined)
    return { field: `stick.${strange.slice(0, 40)}`, problem: 'is unknown here. Known: x, y.' };
  const { x, y } = stick;
  if (!isDeflection(x)) return wrong('stick.x', 'a number from -1 (left) to 1 (right)', x);
  if (!isDeflection(y)) return wrong('stick.y', 'a number from -1 (down) to 1 (up)', y);
  return { type: 'stick', x, y };
}

const isDeflection = (value: unknown): value is number => typeof value === 'number' && Math.abs(value) <= 1;

function readGamepad({ gamepad, down }: Fields): InputAction | Bad {
  if (!isGamepadKey(gamepad)) return wrong('gamepad', `a key in quotes, one of ${gamepadKeys.join(', ')}`, gamepad);
  if (typeof down !== 'boolean') return wrong('down', 'true or false', down);
  return { type: 'gamepad', key: gamepad, down };
}

function readSerial({ serial }: Fields): InputAction | Bad {
  return typeof serial === 'string' ? { type: 'serial', text: serial } : wrong('serial', 'a text in quotes', serial);
}

function readSensor({ sensor, value }: Fields): InputAction | Bad {
  if (typeof sensor !== 'string') return wrong('sensor', 'the name of a sensor in quotes', sensor);
  if (typeof value !== 'string' && typeof value !== 'number') return wrong('value', 'a number or a text', value);
  return { type: 'sensor', id: sensor, value };
}

function readPlace({ place }: Fields): InputAction | Bad {
  const pose = readPose(place, 'place', []);
  return 'problem' in pose ? pose : { type: 'place', pose };
}

function readPlaceBlock({ placeBlock }: Fields): InputAction | Bad {
  const pose = readPose(placeBlock, 'placeBlock', ['id']);
  if ('problem' in pose) return pose;
  const id = isObject(placeBlock) ? placeBlock.id : undefined;
  return typeof id === 'string'
    ? { type: 'place-block', id, pose }
    : wrong('placeBlock.id', "a block's id in quotes", id);
}

function readLamp({ lamp, on }: Fields): InputAction | Bad {
  if (typeof lamp !== 'string') return wrong('lamp', "a lamp's id in quotes", lamp);
  return typeof on === 'boolean' ? { type: 'switch', id: lamp, on } : wrong('on', 'true or false', on);
}

function readBarrier({ barrier, open }: Fields): InputAction | Bad {
  if (typeof barrier !== 'string') return wrong('barrier', "a barrier's id in quotes", barrier);
  return typeof open === 'boolean' ? { type: 'switch', id: barrier, on: open } : wrong('open', 'true or false', open);
}

function readPose(value: unknown, path: string, further: readonly string[]): PlacedPose | Bad {
  if (!isObject(value)) return wrong(path, 'an object { "xMm": …, "yMm": …, "headingDeg": … }', value);
  const known = ['xMm', 'yMm', 'headingDeg', ...further];
  const strange = Object.keys(value).find((key) => !known.includes(key));
  if (strange !== undefined)
    return { field: `${path}.${strange.slice(0, 40)}`, problem: `is unknown here. Known: ${known.join(', ')}.` };
  const { xMm, yMm, headingDeg = 0 } = value;
  if (typeof xMm !== 'number') return wrong(`${path}.xMm`, 'a number', xMm);
  if (typeof yMm !== 'number') return wrong(`${path}.yMm`, 'a number', yMm);
  if (typeof headingDeg !== 'number') return wrong(`${path}.headingDeg`, 'a number', headingDeg);
  return { xMm, yMm, headingDeg };
}

function readNoProgress({ noProgress }: Fields): InputAction | Bad {
  return noProgress === true ? { type: 'no-progress' } : wrong('noProgress', 'true', noProgress);
}

function readInterrupt({ interrupt }: Fields): InputAction | Bad {
  return interrupt === true ? { type: 'interrupt' } : wrong('interrupt', 'true', interrupt);
}

/** A text arrives as `radio.send` of another board sends it, a list of bytes as `radio.send_bytes` does. */
function readRadio({ radio }: Fields): InputAction | Bad {
  if (typeof radio === 'string') return { type: 'radio', text: radio };
  if (!Array.isArray(radio)) return wrong('radio', 'a text in quotes or a list of bytes', radio);
  if (radio.length > MAX_PACKET_BYTES)
    return { field: 'radio', problem: `has ${radio.length} bytes; a packet takes ${MAX_PACKET_BYTES}.` };
  const bytes: number[] = [];
  for (const [index, byte] of radio.entries()) {
    if (!isByte(byte)) return wrong(`radio[${index}]`, 'a whole number from 0 to 255', byte);
    bytes.push(byte);
  }
  return { type: 'radio', bytes };
}

const isByte = (value: unknown): value is number =>
  typeof value === 'number' && Number.isInteger(value) && value >= 0 && value <= 255;

function readArenaSenses({ arenaSenses }: Fields): InputAction | Bad {
  return typeof arenaSenses === 'boolean'
    ? { type: 'arena-senses', on: arenaSenses }
    : wrong('arenaSenses', 'true or false', arenaSenses);
}

/** Reads an edit. Whether it suits the course at its time is checked when the run is made. */
function readEdit({ edit }: Fields): InputAction | Bad {
  const parsed = parseEdit(edit);
  if ('edit' in parsed) return { type: 'edit', edit: parsed.edit };
  const [first] = parsed.problems;
  const path = first?.path ?? '';
  const problem = parsed.problem.slice(path === '' ? 0 : path.length + 2); // "path: what"
  return { field: path === '' ? 'edit' : `edit.${path}`, problem };
}

const wrong = (field: string, wanted: string, found: unknown): Bad => ({
  field,
  problem:
    found === undefined
      ? `is missing; it must be ${wanted}.`
      : `must be ${wanted}, not ${JSON.stringify(found).slice(0, 60)}.`,
});

const isObject = (value: unknown): value is Fields =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
