import { computed, type Ref } from 'vue';

import { courses } from '#catalogue/courses';
import { openFile } from '#intake/file';
import { formatOf } from '#intake/formats';
import { parseTournament } from '#lab/tournament/file';
import { looksLikeTournament } from '#lab/tournament/format';
import { isForOne } from '#lab/tournament/match-setup';
import { listSources } from '#intake/sources';
import { hasTask } from '#simulation/task/task-brief';

import { treeFile, type AddedFile } from '../../kit/files/added-files';
import { shownLanguage, t } from '../../kit/i18n';
import { askBeforeLeaving } from '../../kit/state/ask-before-leaving';
import type { PageParts } from '../../kit/parts';
import { lateModel } from '../../kit/state/late-models';
import { every, laneCount, serveThread } from '../../session/run/serve-thread';
import { compileFirmware } from '../../session/run/worker/firmware';
import { courseName } from '../../session/work/catalogue/first-course';
import { readyScene } from '../../session/work/catalogue/ready-courses';
import type { WorkParts } from '../../session/work/model/parts';
import { handInReader } from '../class/take-files';
import { TournamentModel, type Course } from './model/tournament-model';
import words from './words';

/** `Course.from` of the work that is open in the app. */
const OPEN = 'open';

/** The tournament of this page: it stays while the page is open, also when it is out of sight. */
export const tournamentOf = lateModel(() => {
  const model = new TournamentModel({
    starter: async () => serveThread({ service: 'runs' }, await compileFirmware()),
    every,
    lanes: laneCount(),
  });
  // What was set up by hand would be lost as well.
  askBeforeLeaving(() => model.isUnsaved.value || model.hasUnsavedPrograms.value);
  return model;
});

/** The course and the number of matches that have been played on this page so far. */
export const playedHere = lateModel((app): Ref<{ readonly name: string; readonly count: number }> => {
  const { course, stages } = tournamentOf(app);
  return computed(() => ({
    name: course.value?.name ?? '',
    count: stages.value.reduce((sum, { matches }) => sum + matches.length, 0),
  }));
});

/** The courses that a tournament can have: those in which programs meet, and those in which each drives alone. */
export function coursesNow({ work }: WorkParts): {
  readonly versus: readonly Course[];
  readonly alone: readonly Course[];
} {
  const { scene, course } = work.work.value.project;
  const name = courseName(scene, course);
  const open: Course = { name, label: t(words.open, { name }), from: OPEN, scene };
  const ready = courses.map((one): Course => ({
    name: one.texts[shownLanguage()].name,
    from: one.id,
    scene: one.scene,
  }));
  const all = [open, ...ready].filter((one) => hasTask(one.scene) && one.scene.task.robots !== 'together');
  const isRing = ({ scene: { task } }: Course): number => Number(task.robots === 'ring');
  const versus = all.filter((one) => !isForOne(one.scene)).sort((one, other) => isRing(other) - isRing(one));
  return { versus, alone: all.filter((one) => isForOne(one.scene)) };
}

/** Drops what was played, for something else: asks first if it is not saved. */
export function afterDropping({ dialogs }: Pick<PageParts, 'dialogs'>, model: TournamentModel, act: () => void): void {
  if (!model.isUnsaved.value) {
    act();
    return;
  }
  dialogs.ask({
    kind: 'choose',
    ...{ title: words.dropTitle, text: words.dropText, values: {} },
    choices: [
      { key: 'code.cancel', run: () => undefined },
      { key: words.dropIt, look: 'stop', run: act },
    ],
  });
}

/**
 * Takes files that were dropped or chosen: the file of a tournament is played again, all others are programs of one that has not
 * begun.
 *
 * @returns `null`, or why the file of a tournament cannot be read
 */
export async function takeFiles(
  app: Pick<PageParts, 'dialogs'>,
  model: TournamentModel,
  files: readonly AddedFile[],
): Promise<string | null> {
  for (const added of files) {
    if (!['json', 'other'].includes(formatOf(added.path))) continue;
    const document = await openFile(treeFile(added), readyScene);
    if (document.kind === 'tournament') return openAgain(app, model, document.text, added.path);
  }
  if (model.phase.value !== 'enter') return null;
  const { sources } = await handInReader.open(files);
  if (sources.length > 0) void model.add(sources);
  return null;
}

/**
 * Opens the file of a tournament and plays it again; asks first if another result is not saved.
 *
 * @param name of the file, for the message; left out: it came as text
 * @returns `null`, or why it cannot be read
 */
export function openAgain(
  app: Pick<PageParts, 'dialogs'>,
  model: TournamentModel,
  text: string,
  name = t(words.title),
): string | null {
  const read = parseTournament(text);
  if ('problem' in read) return t(words.badFile, { name, reason: read.problem });
  afterDropping(app, model, () => void model.open(read.tournament));
  return null;
}

/**
 * Adds the programs behind the links in a text, or opens the tournament that it is.
 *
 * @param tell is told why the tournament cannot be read; `null`: it can
 * @returns false if it is neither
 */
export function addText(
  app: Pick<PageParts, 'dialogs'>,
  model: TournamentModel,
  text: string,
  tell: (problem: string | null) => void,
): Promise<boolean> {
  if (looksLikeTournament(text)) {
    tell(openAgain(app, model, text));
    return Promise.resolve(true);
  }
  const sources = listSources(text, readyScene);
  if (sources.length > 0) void model.add(sources);
  return Promise.resolve(sources.length > 0);
}
