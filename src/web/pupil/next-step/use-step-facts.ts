import { computed, shallowRef, watch, type ComputedRef } from 'vue';

import { hasTask } from '#simulation/task/task-brief';

import { useWaiting } from '../../course/editor/use-waiting';
import { shownLanguage, t } from '../../kit/i18n';
import { numberText } from '../../kit/i18n/number-text';
import { goalsInWords, rulesInWords } from '../../session/task/goals';
import { ownLevels } from '../../session/task/own-hint/own-levels';
import goalWords from '../../session/task/words';
import { causeOfEnd } from '../console/error-text';
import type { Drive, StepFacts, StepTask } from './next-step';
import type { StepApp } from './step-app';
import { useNextMission } from './use-next-mission';
import { useVerdict } from './use-verdict';
import type { Goal } from './verdict-view';
import words from './words';

/** The result of a teacher's checks; `null`: the verdict of the course is all there is. */
export interface CheckedFacts {
  readonly state: StepTask['state'];
  readonly told: string;
  readonly stars: number | null;
}

/** The name of a goal, for one or several. */
export function nameOf({ id, of }: Goal): string {
  if (id === 'checkpoints') return t('verdict.checkpoints');
  if (id === 'targets') return t(of === 1 ? 'verdict.target' : 'verdict.targets');
  return t(of === 1 ? 'verdict.block' : 'verdict.blocks');
}

/** Everything that decides on the next step, and what the bar shows besides. */
export function useStepFacts(app: StepApp, checked: () => CheckedFacts | null) {
  const { run, work, layout, mode } = app;
  const verdict = useVerdict(app);
  const isPhone = computed(() => layout.kind.value === 'phone');
  const isTask = computed(() => hasTask(work.scene.value) || work.work.value.project.task !== undefined);
  const drive = computed(() => driveOf(app, isTask.value && verdict.goals.value.length === 0));
  const isBuilding = computed(() => mode.current.value === 'build');
  /** How many probable mistakes have been found in the course. */
  const problems = shallowRef(0);
  const task = useStepTask(app, { verdict, checked, isTask, isPhone });
  const waiting = useWaiting(app);
  const facts = computed((): StepFacts => ({
    mode: isBuilding.value ? 'build' : 'drive',
    isGreeted: layout.isGreeting.value,
    isPhone: isPhone.value,
    drive: drive.value,
    // Only a run that stands is told in seconds: the running clock would change all this with each picture.
    seconds: drive.value === 'stopped' || drive.value === 'over' ? secondsText(run.nowUs.value) : '',
    error: errorOf(app),
    task: task.value,
    course: isBuilding.value ? courseText(app, problems.value) : '',
    waiting: waiting.value,
  }));
  return { facts, verdict, problems, isTask, isBuilding };
}

/** @param isHoldingOut true where the only goal is to last: a program that has ended does not end that */
function driveOf({ run }: Pick<StepApp, 'run'>, isHoldingOut: boolean): Drive {
  const phase = run.phase.value;
  if (phase === 'ready' || phase === 'failed') return 'before';
  if (run.hasEnded.value && !(isHoldingOut && run.isActive.value)) return 'over';
  if (phase === 'paused') return 'paused';
  return phase === 'stopped' || phase === 'killed' ? 'stopped' : 'drives';
}

const secondsText = (timeUs: number): string => numberText(timeUs / 1_000_000, shownLanguage(), 1);

function errorOf(app: StepApp): StepFacts['error'] {
  const ended = app.run.ended.value;
  return ended?.exception ? { line: causeOfEnd(ended, app)?.line ?? null } : null;
}

/** The course in figures. */
function courseText({ work }: Pick<StepApp, 'work'>, wrong: number): string {
  const { size, objects } = work.scene.value;
  const [width, height] = size.map((mm) => numberText(mm / 10, shownLanguage()));
  const things = objects.length;
  const found = [
    t(words.size, { width: width ?? '', height: height ?? '' }),
    things === 1 ? t(words.thing) : t(words.things, { count: things }),
    ...(wrong === 0 ? [] : [wrong === 1 ? t(words.problem) : t(words.problems, { count: wrong })]),
  ];
  return found.join(' · ');
}

interface TaskView {
  readonly verdict: ReturnType<typeof useVerdict>;
  readonly checked: () => CheckedFacts | null;
  readonly isTask: ComputedRef<boolean>;
  readonly isPhone: ComputedRef<boolean>;
}

/** The task; `null`: there is nothing to reach. */
function useStepTask(app: StepApp, { verdict, checked, isTask, isPhone }: TaskView): ComputedRef<StepTask | null> {
  const { task: card, work } = app;
  const { state, goals, early, help, helped, reason, seconds, isOver } = verdict;
  const isMission = computed(() => (card.ready.value?.mission ?? null) !== null && !work.work.value.project.task);
  const next = useNextMission(app, () => isMission.value && state.value === 'passed');
  const reached = useReached(app, verdict);
  const told = computed(() => {
    const passedIn = (): string => t('verdict.passedIn', { seconds: seconds.value });
    if (state.value === 'passed') return [passedIn(), ...help.value].join(' ');
    if (state.value === 'helped') return `${passedIn()} ${t('verdict.doesNotCount')}`;
    // A phone has two short lines for it.
    const advice = early.value ?? (isPhone.value ? '' : (reason.value?.todo ?? ''));
    return `${reason.value?.what ?? ''} ${advice}`.trim();
  });
  const missing = computed(() => {
    const open = goals.value.filter(({ done, of }) => done < of);
    const names = open.map((goal) => (goal.of === 1 ? nameOf(goal) : `${nameOf(goal)} ${figureOf(goal)}`));
    return names.length === 0 ? '' : t(words.stillOpen, { goals: names.join(', ') });
  });
  return computed(() => {
    if (!isTask.value) return null;
    const found = checked();
    return {
      kind: card.handIn.isAsked.value ? 'given' : isMission.value ? 'mission' : 'own',
      state: found?.state ?? state.value,
      told: found?.told ?? told.value,
      wanted: card.hasText.value ? t(words.readTask) : goalsText(app),
      news: state.value === 'helped' ? helped.value : (early.value ?? (isOver.value ? '' : reached.value)),
      isEarly: early.value !== null,
      missing: missing.value,
      hints: { open: card.hints.value, all: card.text.value.hints.length },
      own: { open: card.own.level.value, all: ownLevels(card.own, app) },
      next: next.value,
      isHandedIn: card.handIn.isDone.value,
    };
  });
}

export const figureOf = ({ done, of }: Goal): string => t('verdict.ofMany', { done, of });

/** The goals and rules of the course in a line, where no card says them. */
function goalsText({ work }: Pick<StepApp, 'work'>): string {
  const goals = goalsInWords(work.scene.value, null).map((goal) => t(goalWords.goals[goal.words], goal.values));
  const rules = rulesInWords(work.scene.value, null).filter((rule) => rule.words !== 'ownHands');
  return [...goals, ...rules.map((rule) => t(goalWords.rules[rule.words], rule.values))].join(' · ');
}

/** The goal that was reached last, in words. */
function useReached({ run }: Pick<StepApp, 'run'>, { goals }: Pick<TaskView['verdict'], 'goals'>) {
  const reached = shallowRef('');
  watch(goals, (now, before) => {
    const further = now.filter((goal) => goal.done > (before.find(({ id }) => id === goal.id)?.done ?? goal.done));
    if (further.length > 0)
      reached.value = further
        .map((goal) => t('verdict.reached', { goal: nameOf(goal), done: goal.done, of: goal.of }))
        .join(' ');
  });
  watch(run.phase, (phase) => {
    if (phase === 'starting' || phase === 'ready') reached.value = '';
  });
  return reached;
}
