import type { Day } from '#core/day';

/** Known values of an option or a word, by their list; `values.ts` reads the lists that are not written out. */
export type Choices = 'robots' | 'boards' | 'firmwares' | 'courses' | 'commands' | readonly string[];

/** The kind of path that a value is: a file or folder to read, a file that the command writes, a folder. */
export type PathKind = 'reads' | 'writes' | 'folder';

/** A value of the command line, as help, man page and completion tell it. */
interface ValueAbout {
  readonly choices?: Choices;
  readonly path?: PathKind;
}

/** An option of a command. */
export interface OptionAbout extends ValueAbout {
  /** Name of its value, such as `FILE.csv`; left out: it takes none. */
  readonly value?: string;
  /** Its meaning in the words of help. Lists of `choices` need not be in it. */
  readonly help: string;
  /** Lines below the help that are not wrapped. */
  readonly sample?: readonly string[];
  /** A heading above this option and those after it. */
  readonly heading?: string;
  readonly isRepeated?: true;
}

/** A word of a command that is no option. */
export interface WordAbout extends ValueAbout {
  readonly name: string;
  readonly isRepeated?: true;
}

export type Options = Readonly<Record<string, OptionAbout>>;

/** The facts about a command from which messages, help, man page and completion are made. */
export interface CommandAbout {
  /** One line of the overview. */
  readonly summary: string;
  /** Its forms, each without the command itself. */
  readonly usage: readonly string[];
  /** Paragraphs. */
  readonly text: readonly string[];
  readonly words: readonly WordAbout[];
  readonly options: Options;
  /** Exit codes with their meanings. */
  readonly exits: Readonly<Record<number, string>>;
  /** Examples, each without `parcours`. */
  readonly examples: readonly string[];
}

export interface Problem {
  readonly problem: string;
}

/** The names of those options that take a value. */
export type TextOf<O extends Options> = { [N in keyof O]: O[N] extends { value: string } ? N : never }[keyof O] &
  string;

/** The options that were given to a command. Only names of its own can be asked for. */
export interface Given<O extends Options> {
  /** True if an option was given, with or without a value. */
  has(name: keyof O & string): boolean;
  /** The last value of an option; `null`: it was not given. */
  last(name: TextOf<O>): string | null;
  /** All values of an option, in order. */
  all(name: TextOf<O>): readonly string[];
}

/** The facts outside the line that its reading depends on. */
export interface Around {
  /** Variables of the system, by name. */
  readonly variables: Readonly<Record<string, string | undefined>>;
  /** The day by this computer's calendar. */
  readonly today: Day;
}

/** A command: the facts about it, and the reading of its words. */
export interface Command<O extends Options, Request> extends CommandAbout {
  readonly options: O;
  /** Makes the request from the words that are no options and from the options. */
  read(words: readonly string[], given: Given<O>, around: Around): Request | Problem;
}

/** Gives a command the types of its options. */
export const command = <const O extends Options, Request>(about: Command<O, Request>): Command<O, Request> => about;

/** The request that a command makes of its words. */
export type RequestOf<C> = C extends { read(...given: never[]): infer Read } ? Exclude<Read, Problem> : never;
