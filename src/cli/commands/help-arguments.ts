import { command, type Problem } from './about';

/** The request for help: the words of a command, such as `check` or `probe compare`; none: on all of them. */
export interface HelpOptions {
  readonly about: readonly string[];
}

export const helpAbout = command({
  summary: 'tells about a command and its options, as COMMAND --help does',
  usage: ['[COMMAND]'],
  text: ['Without a command: what there is. man parcours has all of it on one page, where it is installed.'],
  words: [{ name: 'COMMAND', choices: 'commands' }],
  options: {},
  exits: { 0: 'the help was shown', 2: 'there is no such command' },
  examples: ['help check'],
  read: (about): HelpOptions => ({ about }),
});

/** The shells for which there is a completion. */
const shells = ['bash', 'zsh'] as const;
export type Shell = (typeof shells)[number];

/** The request to `parcours completion`. */
export interface CompletionOptions {
  readonly shell: Shell;
}

export const completionAbout = command({
  summary: 'prints what lets bash or zsh complete commands, options and their values',
  usage: [shells.join('|')],
  text: [
    'It completes parcours and npx parcours. For this window: source <(npx parcours completion bash). For each one: put that line into ~/.bashrc or, with zsh, into ~/.zshrc after compinit.',
  ],
  words: [{ name: 'SHELL', choices: shells }],
  options: {},
  exits: { 0: 'the script was printed', 2: 'there is none for this shell' },
  examples: ['completion bash', 'completion zsh'],
  read: readCompletion,
});

/** Reads the words after `parcours completion`. */
function readCompletion([name, ...more]: readonly string[]): CompletionOptions | Problem {
  if (name === undefined) return { problem: `For which shell? ${shells.join(' or ')}` };
  const shell = shells.find((one) => one === name);
  if (shell === undefined) return { problem: `There is no completion for "${name}". Known: ${shells.join(', ')}.` };
  return more[0] === undefined ? { shell } : { problem: `One shell at a time: what is "${more[0]}"?` };
}
