import { commandList, everywhere } from './commands';
import type { CommandAbout, OptionAbout } from './about';
import { helpOf, purpose, typedOption } from './help';
import { listsWith, type Lists } from './lists';

/** The manual page of `parcours` for `man`, in roff. */
export function manPage(version: string): string {
  const lists = listsWith([]);
  const lines = [
    `.TH PARCOURS 1 "" "Parcours ${version}" "User Commands"`,
    ...section('NAME'),
    text('parcours - runs robot programs, checks and converts them, without a window'),
    ...section('SYNOPSIS'),
    ...commandList.flatMap(({ name, usage }) => usage.map((form) => usageOf(name, form))).flatMap(separated),
    ...section('DESCRIPTION'),
    text(purpose),
    text('Each command tells about itself with --help.'),
    ...section('COMMANDS'),
    ...commandList.flatMap((one) => commandLines(one.name, one, lists)),
    ...section('OPTIONS'),
    '.P',
    'Every command takes:',
    ...optionLines(everywhere, lists),
    ...section('EXIT STATUS'),
    ...commandList.flatMap(({ name, exits }) => [
      '.TP',
      bold(name),
      text(Object.entries(exits).map(([code, meaning]) => `${code}: ${meaning}`).join('; ')), // prettier-ignore
    ]),
    ...section('EXAMPLES'),
    '.nf',
    ...commandList.flatMap(({ examples }) => examples.map((line) => text(`parcours ${line}`))),
    '.fi',
  ];
  return `${lines.join('\n')}\n`;
}

const section = (title: string): readonly string[] => [`.SH ${title}`];

const separated = (line: string, place: number): readonly string[] => (place === 0 ? [line] : ['.br', line]);

const usageOf = (name: string, form: string): string => `${bold(`parcours ${name}`)} ${text(form)}`.trimEnd();

const commandLines = (
  name: string,
  { summary, usage, text: told, options }: CommandAbout,
  lists: Lists,
): readonly string[] => [
  `.SS "parcours ${text(name)}"`,
  text(`${summary}.`),
  '.P',
  ...usage.map((form) => usageOf(name, form)).flatMap(separated),
  ...told.flatMap((paragraph) => ['.P', text(paragraph)]),
  ...optionLines(options, lists),
];

const optionLines = (options: Readonly<Record<string, OptionAbout>>, lists: Lists): readonly string[] =>
  Object.entries(options).flatMap(([name, about]) => [
    ...(about.heading === undefined ? [] : ['.P', `.I ${text(about.heading)}`]),
    '.TP',
    bold(typedOption(name, about)),
    ...helpOf(about, lists).flatMap((paragraph, place) => separated(text(paragraph), place)),
    ...(about.sample === undefined ? [] : ['.RS', '.nf', ...about.sample.map(text), '.fi', '.RE']),
  ]);

const bold = (words: string): string => `\\fB${text(words)}\\fR`;

/** A line of text whose signs roff does not take for orders: backslash, leading dot, minus, and what is not ASCII. */
function text(line: string): string {
  const escaped = line
    .replaceAll('\\', '\\e')
    .replaceAll('-', '\\-')
    .replaceAll("'", '\\(aq')
    .replaceAll('"', '\\(dq')
    .replaceAll('^', '\\(ha')
    .replaceAll('~', '\\(ti')
    .replace(
      /[^\u0020-\u007e]/gu,
      (sign) => `\\[u${(sign.codePointAt(0) ?? 0).toString(16).toUpperCase().padStart(4, '0')}]`,
    );
  return escaped.startsWith('.') ? `\\&${escaped}` : escaped;
}
