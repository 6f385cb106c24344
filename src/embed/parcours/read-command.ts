import * as v from 'valibot';

import { FILE_BYTES, projectLimits, utf8Bytes } from '#project/project';

import { commandNames, commandSchemas } from './command-schemas';
import { limits } from './limits';
import { dataProblem, type DataRoom } from './plain-data';
import type { CommandId, CommandName, Commands, RefusalCode } from './protocol';

/** The version of this dialect. */
export const PROTOCOL_VERSION = 1;

/** A command with valid fields. */
export type ReadCommand = {
  [N in CommandName]: { readonly type: N; readonly fields: Commands[N]['fields'] };
}[CommandName];

/** Why a command is not carried out. */
export interface CommandRefusal {
  readonly code: RefusalCode;
  readonly message: string;
  readonly path: string;
  readonly versions?: readonly number[];
}

/** A message for this dialect: its id and its request. */
export interface Incoming {
  /** `null` if no answer is wanted. */
  readonly id: CommandId | null;
  readonly asked: ReadCommand | CommandRefusal;
}

/** Makes a refusal; a long message is cut. */
export function refusal(code: RefusalCode, message: string, path = ''): CommandRefusal {
  const { messageCharacters } = limits;
  const short = message.length > messageCharacters ? `${message.slice(0, messageCharacters)}…` : message;
  return { code, message: short, path: path.slice(0, messageCharacters) };
}

/** True if it is a message of this dialect, of any version; all others are ignored. */
export const isOurs = (message: unknown): message is Readonly<Record<string, unknown>> =>
  typeof message === 'object' && message !== null && typeof (message as { parcours?: unknown }).parcours === 'number';

/** Reads a message of this dialect. */
export function readCommand(message: Readonly<Record<string, unknown>>): Incoming {
  const id = idOf(message['id']);
  if (message['parcours'] !== PROTOCOL_VERSION) {
    const text = `This page speaks version ${String(PROTOCOL_VERSION)} of the protocol, not ${String(message['parcours'])}.`;
    return { id, asked: { ...refusal('unknown-version', text, 'parcours'), versions: [PROTOCOL_VERSION] } };
  }
  const type = commandNames.find((name) => name === message['type']);
  if (type === undefined) {
    const text = `There is no such command; known are ${commandNames.join(', ')}.`;
    return { id, asked: refusal('unknown-command', text, 'type') };
  }
  const problem = dataProblem(message, roomOf(type));
  if (problem !== null) {
    const text =
      problem === 'too-large' ? 'The message is larger than any that makes sense.' : 'A message holds plain data only.';
    return { id, asked: refusal(problem === 'too-large' ? 'too-large' : 'wrong-message', text) };
  }
  return { id, asked: readFields(type, message) };
}

function idOf(id: unknown): CommandId | null {
  if (typeof id === 'string') return id.length <= limits.idCharacters ? id : null;
  return typeof id === 'number' && Number.isFinite(id) ? id : null;
}

function roomOf(type: CommandName): DataRoom {
  const { depth } = limits;
  switch (type) {
    case 'set-project':
    case 'set-scene':
    case 'edit':
      return { values: limits.documentValues, characters: limits.documentCharacters, depth };
    case 'set-files':
      return { values: limits.values, characters: projectLimits.files * 2 * FILE_BYTES, depth };
    default:
      return { values: limits.values, characters: limits.characters, depth };
  }
}

const ENVELOPE: ReadonlySet<string> = new Set(['parcours', 'id', 'type']);

function readFields(type: CommandName, message: Readonly<Record<string, unknown>>): ReadCommand | CommandRefusal {
  const given = Object.fromEntries(Object.entries(message).filter(([key]) => !ENVELOPE.has(key)));
  const schema: v.GenericSchema = commandSchemas[type];
  const parsed = v.safeParse(schema, given, { abortEarly: true });
  if (!parsed.success) {
    const [issue] = parsed.issues;
    const path = v.getDotPath(issue) ?? '';
    return refusal('wrong-message', `${path === '' ? type : path}: ${issue.message}`, path);
  }
  const command = { type, fields: parsed.output } as ReadCommand; // the schema of this very type has validated it
  return command.type === 'set-files' ? (filesProblem(command.fields.files) ?? command) : command;
}

function filesProblem(files: Commands['set-files']['fields']['files']): CommandRefusal | null {
  const index = files.findIndex(({ text }) => utf8Bytes(text) > FILE_BYTES);
  if (index < 0) return null;
  const path = `files[${String(index)}].text`;
  return refusal('wrong-message', `${path}: a file may have ${String(FILE_BYTES)} bytes.`, path);
}
