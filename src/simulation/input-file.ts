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
  for (const [index, entry] of value.entries()) {
    const read = readEntry(entry);
    if ('problem' in read)
      return { problem: `[${index}]${read.field === '' ? '' : `.${read.field}`}: ${read.problem}` };
    inputs.push(read);
  }
  return { inputs };
}

function readEntry(entry: unknown): InputEvent | Bad {
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
  const action = read(entry);
  return 'problem' in action ? action : { timeUs: at.us, ...(device !== undefined && { device }), action };
}

/** The pads of all boards together; whether the run's board has a pad is checked when the run is made. */
const touchPads = ['pinLogo', 'pin0', 'pin1', 'pin2', 'pin3'];

/** The longest packet that radio.config allows: micropython-microbit-v2 modradio.c. */
const MAX_PACKET_BYTES = 251;

type ReadAction = (entry: Fields) => InputAction | Bad;

/** How to read each kind of entry, and which further fields it has. */
const readers: Readonly<Record<string, { readonly fields: readonly string[]; readonly read: ReadAction }>> = {
  button: { fields: ['down'], read: readButton },
  touch: { fields: ['down'], read: readTouch },
  serial: { fields: [], read: readSerial },
  sensor: { fields: ['value'], read: readSensor },
  place: { fields: [], read: readPlace },
  placeBlock: { fields: [], read: readPlaceBlock },
  noProgress: { fields: [], read: readNoProgress },
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
