import { limits } from '#intake/formats';
import { progressText } from '#lab/say';
import { comparison, differences, drawOf, parseTournament, type ToldTournament } from '#lab/tournament/file';
import { playedStages, wholeCount, type Stage } from '#lab/tournament/stages';
import { comparedJson, comparedSum, comparedText } from '#lab/tournament/compared-texts';
import { readLimited } from '../read-files';
import { CountProgress, refuse } from '../results-out';
import { printable, type Terminal } from '../terminal';
import { matchPlayer } from './play-matches';
import type { VerifyOptions } from './tournament-arguments';

/**
 * Carries out `parcours tournament --verify`: plays the tournament of a file again, and compares match by match.
 *
 * @returns the exit code: 0 all is as the file says, 1 something is not, 2 no tournament
 */
export async function verifyTournament(options: VerifyOptions, terminal: Terminal): Promise<0 | 1 | 2> {
  const file = readLimited(options.verify, limits.json);
  if ('problem' in file) return refuse(file.problem, terminal);
  const read = parseTournament(file.text);
  if ('problem' in read) return refuse(`${options.verify}: ${read.problem}`, terminal);
  const { tournament } = read;
  const stages = await playAgain(tournament, options, terminal);
  if ('problem' in stages) return refuse(`${options.verify}: ${stages.problem}`, terminal);
  const compared = comparison(stages, tournament.told);
  const { json, quiet, lang } = options;
  if (json) terminal.line(comparedJson(compared));
  else if (!quiet) {
    for (const match of compared.matches) terminal.line(printable(comparedText(match, lang)));
    terminal.line(comparedSum(compared, lang));
  }
  return differences(compared) === 0 ? 0 : 1;
}

async function playAgain(
  tournament: ToldTournament,
  { jobs, quiet, json, lang }: VerifyOptions,
  terminal: Terminal,
): Promise<readonly Stage[] | { readonly problem: string }> {
  const draw = drawOf(tournament);
  const of = wholeCount(draw);
  const progress = new CountProgress(terminal, of, quiet || json, (done) => progressText(done, of, lang));
  const player = await matchPlayer(tournament, Math.min(jobs, of), () => progress.add(1));
  const found = await playedStages(draw, (plan, _, pairings) => player.play(plan, pairings));
  player.stop();
  terminal.clearProgress();
  return found ?? { problem: player.problem };
}
