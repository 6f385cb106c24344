/**
 * The messages of the micro:bit dialect: those that the simulator of the micro:bit Python editor exchanges with the
 * page around it (micropython-microbit-v2-simulator, src/simulator.ts and src/board/). Every message is `{ kind, … }`;
 * messages of another kind are ignored here.
 */
import * as v from 'valibot';

import { FILE_BYTES } from '#project/project';

import { isPlainObject } from '../plain-object';

/** Version of this protocol: the first that hosts of the official simulator's v0.1 understand. */
export const MICROBIT_VERSION = '0.1';

/** The words of the host that the page shows; others are ignored. */
export const LABEL_NAMES = ['button-a', 'button-b', 'touch-logo', 'start-simulator'] as const;

/** Maximum sizes of a message. Chosen: far beyond the messages of any known host. */
export const microbitLimits = {
  labelCharacters: 300,
  labels: 200,
  /** Far more than any project; the page itself accepts fewer and says so. */
  files: 500,
  serialCharacters: FILE_BYTES,
  packetBytes: 4096,
  idCharacters: 50,
} as const;

const text = (characters: number) => v.pipe(v.string(), v.maxLength(characters));

/**
 * A record with at most this many entries, which are counted before they are looked at. Lists and bytes are refused:
 * counting their entries would make a text of each of millions of indices.
 */
const record = <T extends v.GenericSchema>(value: T, most: number) =>
  v.pipe(
    v.custom<Record<string, v.InferInput<T>>>((input) => isPlainObject(input) && Object.keys(input).length <= most),
    v.record(v.string(), value),
  );

const about = v.description;

const config = v.object({
  kind: v.literal('config'),
  language: v.pipe(
    text(microbitLimits.labelCharacters),
    about('The language of the host, such as `en` or `fr-CA`. An unknown language changes nothing.'),
  ),
  translations: v.pipe(
    record(text(microbitLimits.labelCharacters), microbitLimits.labels),
    about(
      'Words for `button-a`, `button-b`, `touch-logo` and `start-simulator`. Missing ones are replaced by our own.',
    ),
  ),
});

const flash = v.object({
  kind: v.literal('flash'),
  filesystem: v.pipe(
    record(v.instance(Uint8Array), microbitLimits.files),
    about(
      'The files by name, UTF-8 as Uint8Array. Without `main.py` the REPL comes at once. Files that the page cannot hold are left out and named by `internal_error`: more than 20 files, files larger than 256 KiB, files that are not text, names with spaces and the like.',
    ),
  ),
});

const stop = v.object({ kind: v.literal('stop') });
const reset = v.object({ kind: v.literal('reset') });
const mute = v.object({ kind: v.literal('mute') });
const unmute = v.object({ kind: v.literal('unmute') });

const serialInput = v.object({
  kind: v.literal('serial_input'),
  data: v.pipe(
    text(microbitLimits.serialCharacters),
    about('What is typed; `\\x03` interrupts the program, `\\x04` starts it again.'),
  ),
});

const radioInput = v.object({
  kind: v.literal('radio_input'),
  data: v.pipe(
    v.instance(Uint8Array),
    v.maxLength(microbitLimits.packetBytes),
    about('The packet. A packet for `radio.receive` begins with the bytes 1, 0, 1. It is lost while the radio is off.'),
  ),
});

const setValue = v.object({
  kind: v.literal('set_value'),
  id: v.pipe(text(microbitLimits.idCharacters), about('A key of the state, such as `temperature` or `buttonA`.')),
  value: v.pipe(
    v.union([v.number(), text(microbitLimits.idCharacters)]),
    about('A number (also as text) or the name of a gesture. A value outside the present range changes nothing.'),
  ),
});

/** The commands of a host. */
export const microbitCommand = v.variant('kind', [
  config,
  flash,
  stop,
  reset,
  mute,
  unmute,
  serialInput,
  radioInput,
  setValue,
]);
export type MicrobitCommand = v.InferOutput<typeof microbitCommand>;

const rangeSensor = v.object({
  type: v.literal('range'),
  id: v.string(),
  min: v.number(),
  max: v.number(),
  value: v.number(),
  unit: v.optional(v.string()),
  lowThreshold: v.optional(v.number()),
  highThreshold: v.optional(v.number()),
});
const enumSensor = v.object({
  type: v.literal('enum'),
  id: v.string(),
  choices: v.array(v.string()),
  value: v.string(),
});
const radioState = v.object({ type: v.literal('radio'), enabled: v.boolean(), group: v.number() });
const logState = v.object({ type: v.literal('dataLogging'), logFull: v.boolean() });

/** One entry of the state. */
export const stateEntry = v.variant('type', [rangeSensor, enumSensor, radioState, logState]);
export type StateEntry = v.InferOutput<typeof stateEntry>;

/** Sensor values of the board, and the state of its radio and its log, by id. */
export const microbitState = v.record(v.string(), stateEntry);
export type MicrobitState = Readonly<Record<string, StateEntry>>;

const ready = v.object({
  kind: v.literal('ready'),
  state: v.pipe(microbitState, about('Every sensor of the board, by id.')),
});
const requestFlash = v.object({ kind: v.literal('request_flash') });
const stateChange = v.object({
  kind: v.literal('state_change'),
  change: v.pipe(microbitState, about('The entries that have changed, each whole; all entries when a program ends.')),
});
const serialOutput = v.object({
  kind: v.literal('serial_output'),
  data: v.pipe(v.string(), about('What the program and the REPL print; lines end in `\\r\\n`.')),
});
const radioOutput = v.object({
  kind: v.literal('radio_output'),
  data: v.pipe(v.instance(Uint8Array), about('A packet. A packet of `radio.send` begins with the bytes 1, 0, 1.')),
});
const logOutput = v.object({
  kind: v.literal('log_output'),
  headings: v.optional(v.pipe(v.array(v.string()), about('All columns, when they have changed.'))),
  data: v.optional(v.pipe(v.array(v.string()), about('A row, in the order of the columns.'))),
});
const logDelete = v.object({ kind: v.literal('log_delete') });
const internalError = v.object({
  kind: v.literal('internal_error'),
  error: v.pipe(
    v.object({ name: v.string(), message: v.string() }),
    about('An `Error` that says in English what could not be done.'),
  ),
});

/** The messages of the page. */
export const microbitEvent = v.variant('kind', [
  ready,
  requestFlash,
  stateChange,
  serialOutput,
  radioOutput,
  logOutput,
  logDelete,
  internalError,
]);
export type MicrobitEvent = v.InferOutput<typeof microbitEvent>;

/** Every message with its purpose: the manual is made from it. */
export const microbitMessages = [
  { name: 'config', direction: 'in', schema: config, about: 'Sets the language and the words of the board.' },
  { name: 'flash', direction: 'in', schema: flash, about: 'Puts a program on the board and starts it, at any time.' },
  { name: 'stop', direction: 'in', schema: stop, about: 'Ends the run. The play button appears over the board.' },
  {
    name: 'reset',
    direction: 'in',
    schema: reset,
    about: 'Starts the program on the board again, also after a stop.',
  },
  { name: 'mute', direction: 'in', schema: mute, about: 'Silences the loudspeaker.' },
  { name: 'unmute', direction: 'in', schema: unmute, about: 'Turns the loudspeaker on again.' },
  { name: 'serial_input', direction: 'in', schema: serialInput, about: 'Types on the serial line.' },
  { name: 'radio_input', direction: 'in', schema: radioInput, about: 'Delivers a packet by radio.' },
  {
    name: 'set_value',
    direction: 'in',
    schema: setValue,
    about: 'Sets what a sensor measures. The value holds for later runs.',
  },
  { name: 'ready', direction: 'out', schema: ready, about: 'The page is ready. Sent once.' },
  { name: 'request_flash', direction: 'out', schema: requestFlash, about: 'Play was pressed: send `flash`.' },
  {
    name: 'state_change',
    direction: 'out',
    schema: stateChange,
    about:
      'Somebody pressed something on the page; the radio, the log, the range of the accelerometer or the thresholds of the microphone changed; or a program ended.',
  },
  { name: 'serial_output', direction: 'out', schema: serialOutput, about: 'Something was printed.' },
  { name: 'radio_output', direction: 'out', schema: radioOutput, about: 'The program sent a packet by radio.' },
  { name: 'log_output', direction: 'out', schema: logOutput, about: 'The program logged a row.' },
  {
    name: 'log_delete',
    direction: 'out',
    schema: logDelete,
    about: 'The log is empty. Sent with every flash, and whenever the log is deleted.',
  },
  { name: 'internal_error', direction: 'out', schema: internalError, about: 'Something could not be done.' },
] as const;
