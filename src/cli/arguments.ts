import { dayOf } from '#core/day';
import type { Around, Command, Given, Options, RequestOf } from './commands/about';
import { commandList, commands, commandsAt, everywhere, type CommandName } from './commands/commands';
import { readLine, unknownProblem, wordsOf } from './commands/given';
import { nearest } from './commands/nearest';

/** The request on the command line. */
export type Asked =
  | { [N in CommandName]: { readonly type: N; readonly options: RequestOf<(typeof commands)[N]> } }[CommandName]
  | { readonly type: 'version' }
  /** `help`: the command that tells more. */
  | { readonly type: 'bad'; readonly problem: string; readonly help: string };

/** All options of all commands: an option has a value in each of them, or in none. */
const allOptions: Options = Object.assign({}, ...commandList.map(({ options }) => options), everywhere) as Options;

/** This computer, now. */
function here(): Around {
  const now = new Date();
  return { variables: process.env, today: dayOf(now.getFullYear(), now.getMonth() + 1, now.getDate()) };
}

/** Reads the words after `parcours`. */
export function parseCommand(line: readonly string[], around: Around = here()): Asked {
  const words = wordsOf(line, allOptions);
  const name = nameOf(words);
  if (name === null) return parseWithoutCommand(line, words);
  const { options } = commands[name];
  const read = readLine(line, { ...options, ...everywhere }, (option, typed) => strangeOption(option, typed, name));
  if ('problem' in read) return bad(read.problem, helpOf(name));
  if (read.given.has('version')) return { type: 'version' };
  if (read.given.has('help')) return helpOn(name.split(' '));
  const own = read.words.slice(name.split(' ').length);
  if (name === 'help') return helpOn(own);
  return requestOf(name, own, read.given, around);
}

/** The command with which the words begin; `null`: none. */
const nameOf = (words: readonly string[]): CommandName | null =>
  commandList.find(({ name }) => name.split(' ').every((word, place) => word === words[place]))?.name ?? null;

const helpOf = (name: CommandName): string => `npx parcours ${name} --help`;

const bad = (problem: string, help = 'npx parcours --help'): Asked => ({ type: 'bad', problem, help });

function requestOf(name: CommandName, words: readonly string[], given: Given<Options>, around: Around): Asked {
  const about = commands[name] as Command<Options, object>;
  const request = about.read(words, given, around);
  return 'problem' in request ? bad(request.problem, helpOf(name)) : ({ type: name, options: request } as Asked);
}

function parseWithoutCommand(line: readonly string[], words: readonly string[]): Asked {
  const read = readLine(line, allOptions, (option, typed) => unknownProblem(typed, option, Object.keys(allOptions)));
  const [first] = words;
  if (first !== undefined && commandsAt([first]).length === 0) return bad(unknownCommand(words));
  if ('problem' in read) return bad(read.problem);
  if (read.given.has('version')) return { type: 'version' };
  if (read.given.has('help')) return helpOn(words);
  if (first === undefined) return bad('What shall it do? For example: parcours run main.py');
  return words.length === 1 ? bad(`${first}: which of its commands? ${namesOf(commandsAt([first]))}`) : helpOn(words);
}

const namesOf = (list: typeof commandList): string => list.map(({ name }) => name).join(', ');

/** Help on the commands that begin with these words. */
const helpOn = (about: readonly string[]): Asked =>
  commandsAt(about).length === 0 ? bad(unknownCommand(about)) : { type: 'help', options: { about } };

/** The problem with words that begin no command. */
function unknownCommand(words: readonly string[]): string {
  const names = commandList.map(({ name }) => name);
  const [first = '', second] = words;
  const family = commandsAt([first]).length > 0 && second !== undefined;
  const typed = family ? `${first} ${second}` : first;
  const meant = nearest(typed, family ? names : [...names, ...names.map((name) => name.split(' ')[0] ?? name)]);
  return `Unknown command "${typed}". ${meant === null ? `There are: ${names.join(', ')}.` : `Did you mean ${meant}?`}`;
}

/** The problem with an option that is not one of the command's. */
function strangeOption(option: string, typed: string, name: CommandName): string {
  const known = Object.keys(commands[name].options);
  const others = commandList.filter(({ options }) => Object.hasOwn(options, option));
  if (others.length === 0) return unknownProblem(typed, option, [...known, ...Object.keys(everywhere)]);
  const here = known.length === 0 ? 'takes none' : `takes ${known.map((one) => `--${one}`).join(', ')}`;
  return `--${option} is not for ${name}, but for ${namesOf(others)}. ${name} ${here}.`;
}
