import { checkAbout } from '../check/check-arguments';
import { classAddAbout, classMergeAbout, classReportAbout, classSetAbout } from '../class/class-arguments';
import { convertAbout } from '../convert/convert-arguments';
import { hintAbout } from '../hint/hint-arguments';
import { probeCompareAbout } from '../probe/probe-arguments';
import { sweepAbout } from '../lab/sweep-arguments';
import { tournamentAbout } from '../lab/tournament-arguments';
import { replayAbout } from '../replay/replay-arguments';
import { runAbout } from '../run-arguments';
import type { CommandAbout, Options } from './about';
import { completionAbout, helpAbout } from './help-arguments';

/**
 * All commands in the order of the help, each under its words. Parser, messages, help, man page and completions are made of them.
 */
export const commands = {
  run: runAbout,
  check: checkAbout,
  sweep: sweepAbout,
  hint: hintAbout,
  tournament: tournamentAbout,
  'class add': classAddAbout,
  'class set': classSetAbout,
  'class merge': classMergeAbout,
  'class report': classReportAbout,
  convert: convertAbout,
  replay: replayAbout,
  'probe compare': probeCompareAbout,
  completion: completionAbout,
  help: helpAbout,
} as const;

export type CommandName = keyof typeof commands;

/** The options that every command takes. */
export const everywhere = {
  help: { help: 'tells about the command' },
  version: { help: 'the version of Parcours' },
} as const satisfies Options;

/** The commands with their names. */
export const commandList: readonly (CommandAbout & { readonly name: CommandName })[] = Object.entries(commands).map(
  ([name, about]) => ({ ...about, name: name as CommandName }),
);

/** The commands that begin with these words: `probe` has several of one family, `probe compare` is one. */
export const commandsAt = (words: readonly string[]): typeof commandList =>
  commandList.filter(({ name }) => words.every((word, place) => name.split(' ')[place] === word));
