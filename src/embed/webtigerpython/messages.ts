/**
 * The messages of WebTigerPython's dialect, version 2025, both directions: each is `{ type, data }`. The messages of
 * its public integrations are fixed; where they leave the shape of `data` open, the shape here is our own.
 */
import * as v from 'valibot';

import { FILE_BYTES, NAME_CHARACTERS, projectLimits } from '#project/project';

import { LAYOUT_CHARACTERS } from './words';

/** The version of WebTigerPython's interface that this dialect follows. */
export const VERSION = '2025';

/** Longest name of a microcomputer or language, in characters. Chosen: several times the longest. */
const WORD_CHARACTERS = 100;
/** The most entries of one level of a layout. Chosen: it has three panes. */
const LAYOUT_ENTRIES = 20;

const { pipe, description } = v;
const word = pipe(v.string(), v.maxLength(WORD_CHARACTERS));

/** A list whose entries are read only if it is short enough. */
const listOf = <S extends v.GenericSchema>(item: S, most: number) =>
  pipe(v.array(v.unknown()), v.minLength(1), v.maxLength(most), v.array(item));

const file = v.object({
  name: pipe(v.string(), v.maxLength(NAME_CHARACTERS), description('Letters, digits, `_`, `-` and `.`.')),
  data: pipe(v.string(), v.maxLength(FILE_BYTES), description('Its text.')),
});
const programText = pipe(v.string(), v.maxLength(FILE_BYTES), description('The text of `main.py` alone.'));

/** `data` of `files`. */
export const filesData = pipe(
  v.union([listOf(file, projectLimits.files), file, programText]),
  description(
    'All files of the program as a list, or a single file, or only its text. Without a `main.py` the first file is the program.',
  ),
);

/** A field that counts as not given if its value makes no sense. */
const given = <S extends v.GenericSchema>(schema: S, about: string) =>
  v.optional(v.fallback(pipe(v.union([schema, v.undefined()]), description(about)), undefined));
const flag = v.union([v.boolean(), v.picklist(['', 'true', 'false', '1', '0'])]);

/** `data` of `settings`. Unknown fields change nothing. */
export const settingsData = v.object({
  code: given(pipe(programText, v.nonEmpty()), 'The text of a program, as `files` has it.'),
  device: given(word, '`micro:bit`, `Calliope mini 1/2`, `Calliope mini 3`, `-`, or our id of a microcomputer.'),
  lang: given(word, '`de`, `fr`, `it` or `en`, also with a region.'),
  dark_mode: given(flag, 'Dark or light.'),
  layout: given(
    v.union([pipe(v.string(), v.maxLength(LAYOUT_CHARACTERS)), listOf(v.unknown(), LAYOUT_ENTRIES)]),
    'The panes that are shown, as a list or as its JSON: `Editor` (the program), `Canvas` (board and arena), `Console`. The list may be nested; the page decides where the panes go.',
  ),
  hide_topbar: given(flag, 'Hides the bar.'),
  full_screen: given(flag, 'Shows only board and arena.'),
});

/** The messages of a host. */
export const hostMessage = v.variant('type', [
  v.object({ type: v.literal('files'), data: filesData }),
  v.object({ type: v.literal('settings'), data: settingsData }),
  v.object({ type: v.literal('run_code') }),
]);

/** A valid message of a host. */
export type HostMessage = v.InferOutput<typeof hostMessage>;
/** The settings of a host. */
export type SettingsData = v.InferOutput<typeof settingsData>;

const nothing = pipe(v.null(), description('Nothing.'));
const text = (about: string) => pipe(v.string(), description(about));

/** `data` of the page's messages. */
export const pageData = {
  pythonReady: nothing,
  code: pipe(
    v.array(v.object({ name: v.string(), data: v.string() })),
    description('All files of the program, `main.py` first, in the form of `files`.'),
  ),
  output: text('The next piece of what the program prints; lines end in `\\n`, a piece may end anywhere.'),
  error: text('The traceback of the exception that ended the program, or why it could not start.'),
  full_output: text(
    `The whole output of the program with the traceback at its end. If it is very long, only its last part.`,
  ),
  program_finished: nothing,
} as const;

/** A message of the page. */
export type PageMessage = {
  [Name in keyof typeof pageData]: {
    readonly type: Name;
    readonly data: v.InferOutput<(typeof pageData)[Name]>;
  };
}[keyof typeof pageData];
