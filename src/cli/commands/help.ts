import type { CommandAbout, OptionAbout } from './about';
import { commandList, commandsAt, everywhere } from './commands';
import { listsWith, valuesOf, type Lists } from './lists';

/** Longest line, and the column where descriptions begin. */
const [WIDTH, MARGIN] = [100, 22];

type NamedCommand = CommandAbout & { readonly name: string };

/** The text of `parcours --help`, or that on the commands that begin with these words. */
export function helpText(words: readonly string[]): string {
  const lists = listsWith([]);
  const lines = words.length === 0 ? overview() : commandsAt(words).flatMap((one) => ['', ...helpOn(one, lists)]);
  return `${lines.join('\n').trim()}\n`;
}

/** The sentences about Parcours at the head of help and man page. */
export const purpose = 'Parcours runs a micro:bit program with a simulated robot, without a window.';

function overview(): readonly string[] {
  const names = commandList.flatMap((one) => entry(one.name, [one.summary]));
  const usages = commandList.filter(({ options }) => Object.keys(options).length > 0);
  return [
    ...[purpose, ''],
    ...usages.flatMap(usageLines),
    ...['', 'Commands', ...names],
    ...['', 'Options everywhere', ...optionLines(everywhere, null)],
    ...['', 'All about one command: npx parcours help COMMAND'],
    ...exampleLines(usages.map(({ examples }) => examples[0] ?? '')),
  ];
}

function helpOn(one: NamedCommand, lists: Lists): readonly string[] {
  const { name, summary, text, options, exits, examples } = one;
  const codes = Object.entries(exits).map(([code, meaning]) => `${code} ${meaning}`);
  return [
    ...wrapped(`parcours ${name}: ${summary}`, 0),
    ...['', ...usageLines(one)],
    ...text.flatMap((paragraph) => ['', ...wrapped(paragraph, 0)]),
    ...(Object.keys(options).length > 0 ? ['', ...optionLines(options, lists)] : []),
    ...['', ...wrapped(`Exit code: ${codes.join('; ')}.`, 0)],
    ...exampleLines(examples),
  ];
}

const usageLines = ({ name, usage }: NamedCommand): readonly string[] =>
  usage.map((form) => `  npx parcours ${name} ${form}`);

const exampleLines = (examples: readonly string[]): readonly string[] => [
  ...['', 'Examples'],
  ...examples.map((line) => `  npx parcours ${line}`),
];

/** The options, each with its help. */
const optionLines = (options: Readonly<Record<string, OptionAbout>>, lists: Lists | null): readonly string[] =>
  Object.entries(options).flatMap(([name, about], place) => [
    ...(about.heading === undefined ? [] : [...(place === 0 ? [] : ['']), about.heading]),
    ...entry(typedOption(name, about), helpOf(about, lists)),
    ...(about.sample ?? []).map((line) => ' '.repeat(MARGIN) + line),
  ]);

/** An option as it is typed, with the name of its value. */
export const typedOption = (name: string, { value }: OptionAbout): string =>
  `--${name}${value === undefined ? '' : ` ${value}`}`;

/** The paragraphs about an option: its help, and the values that it may have. */
export function helpOf({ value, help, choices, isRepeated }: OptionAbout, lists: Lists | null): readonly string[] {
  const values = choices === undefined || lists === null ? [] : valuesOf(choices, lists);
  const isSaid = values.length === 0 || values.join('|') === value;
  const often = isRepeated === true ? ['may be given several times'] : [];
  return [help, ...(isSaid ? [] : [`one of ${values.join(', ')}`]), ...often];
}

/** A name, and beside it what is said of it; below it where the name is too long. */
function entry(name: string, said: readonly string[]): readonly string[] {
  const lines = said.flatMap((paragraph) => wrapped(paragraph, MARGIN));
  const head = `  ${name}`;
  return head.length < MARGIN - 1
    ? [head.padEnd(MARGIN) + (lines[0] ?? '').trimStart(), ...lines.slice(1)]
    : [head, ...lines];
}

/** A paragraph in lines that end in time, all indented. */
function wrapped(text: string, indent: number): readonly string[] {
  const lines: string[] = [];
  for (const word of text.split(' ')) {
    const last = lines.at(-1);
    if (last !== undefined && last.length + 1 + word.length <= WIDTH) lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(' '.repeat(indent) + word);
  }
  return lines;
}
