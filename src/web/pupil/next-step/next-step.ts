import {
  mdiAlertCircleOutline,
  mdiCheckCircle,
  mdiCheckCircleOutline,
  mdiCircleEditOutline,
  mdiClipboardCheckOutline,
  mdiHandBackRightOutline,
  mdiPause,
  mdiPlayCircleOutline,
  mdiStopCircleOutline,
  mdiTimerOutline,
} from '@mdi/js';

import { t } from '../../kit/i18n';
import type { ArenaMode } from '../../session/mode/mode-model';
import words from './words';

/** The ground of the bar: the page's own, not yet, done, error. */
export type StepTone = 'plain' | 'notYet' | 'done' | 'error';

/** The action of the bar's button. */
export type StepAction =
  'run' | 'hint' | 'own-hint' | 'mission' | 'stars' | 'missions' | 'hand-in' | 'again' | 'change' | 'try' | 'restart';

/** The one button of the bar. */
export interface StepButton {
  readonly action: StepAction;
  readonly text: string;
  /** True if it leads on: then it is the page's ink button. */
  readonly isInk: boolean;
}

/** The states of the bar. */
export type StepKind =
  | 'press'
  | 'ready'
  | 'drives'
  | 'paused'
  | 'stopped'
  | 'over'
  | 'notYet'
  | 'helped'
  | 'checking'
  | 'done'
  | 'error'
  | 'build'
  | 'waiting';

/** The state of the arena, its reason, and the next step. */
export interface NextStep {
  readonly kind: StepKind;
  readonly tone: StepTone;
  /** The path of its icon. */
  readonly sign: string;
  /** Empty while it drives: there the clock stands. */
  readonly title: string;
  readonly reason: string;
  readonly button: StepButton | null;
}

/** The state of a run. `over`: its programs have ended. */
export type Drive = 'before' | 'drives' | 'paused' | 'stopped' | 'over';

/** The task as the bar sees it. */
export interface StepTask {
  /** `mission`: of the ladder; `given`: handed out; `own`: any other course with goals. */
  readonly kind: 'mission' | 'given' | 'own';
  /** The verdict; of a teacher's task also `checking` and `lacking`. */
  readonly state: 'open' | 'passed' | 'helped' | 'failed' | 'checking' | 'lacking';
  /** The verdict in a sentence: the time or the reason. */
  readonly told: string;
  /** The instruction before the first run. */
  readonly wanted: string;
  /** The goal that was just reached, or came too early, in words. */
  readonly news: string;
  readonly isEarly: boolean;
  /** The goals that are still open, in words. */
  readonly missing: string;
  /** The hints that are open, and all of them. */
  readonly hints: { readonly open: number; readonly all: number };
  /** The levels of the hint to the pupil's own program that are open, and all that there are now. */
  readonly own: { readonly open: number; readonly all: number };
  /** The next mission, stars that are still to be had, the list of missions; `null`: not known yet. */
  readonly next: 'mission' | 'stars' | 'missions' | null;
  readonly isHandedIn: boolean;
}

/** All that decides on the next step. */
export interface StepFacts {
  readonly mode: ArenaMode;
  /** True on a first visit, before anything was chosen or changed. */
  readonly isGreeted: boolean;
  readonly isPhone: boolean;
  readonly drive: Drive;
  /** Simulated time, in s, in words. */
  readonly seconds: string;
  /** The error that ended the program; `line`: in one of its files. */
  readonly error: { readonly line: number | null } | null;
  /** `null`: there is nothing to reach. */
  readonly task: StepTask | null;
  /** The course in figures: size, things, problems. */
  readonly course: string;
  /** Changes that only the next start takes up, in words; empty: none. */
  readonly waiting: string;
}

const SIGNS: Readonly<Record<StepKind, string>> = {
  press: mdiPlayCircleOutline,
  ready: mdiPlayCircleOutline,
  drives: mdiTimerOutline,
  paused: mdiPause,
  stopped: mdiStopCircleOutline,
  over: mdiCheckCircleOutline,
  notYet: mdiAlertCircleOutline,
  helped: mdiHandBackRightOutline,
  checking: mdiClipboardCheckOutline,
  done: mdiCheckCircle,
  error: mdiAlertCircleOutline,
  build: mdiCheckCircleOutline,
  waiting: mdiCircleEditOutline,
};

/** The next step. It depends on nothing but these facts and the language. */
export function nextStep(facts: StepFacts): NextStep {
  const { mode, drive, error, task, waiting } = facts;
  const decided = task === null || task.state === 'open' ? null : decidedStep(task);
  if (waiting !== '' && decided === null)
    return step('waiting', 'plain', t(words.waiting), waiting, action('restart', t('editing.restart')));
  if (mode === 'build')
    return step('build', 'plain', t(words.saved), facts.course, action('try', t(words.tryOut), true));
  if (error !== null && task?.state !== 'passed') return errorStep(error, facts.isPhone);
  if (decided !== null) return decided;
  if (drive === 'before') return beforeStep(facts);
  if (task !== null && drive === 'over') return notYet(task, task.isEarly ? task.news : task.missing);
  return runningStep(facts);
}

/** A run that has not decided anything. */
function runningStep({ drive, seconds, task }: StepFacts): NextStep {
  const [news, missing] = [task?.news ?? '', task?.missing ?? ''];
  if (drive === 'drives') return step('drives', task?.isEarly === true ? 'notYet' : 'plain', '', news);
  if (drive === 'paused') return step('paused', 'plain', t(words.paused), news);
  const far = `${t(words.after, { seconds })} ${missing}`.trim();
  return drive === 'stopped'
    ? step('stopped', 'plain', t(words.stopped), far)
    : step('over', 'plain', t(words.over), far);
}

function beforeStep({ isGreeted, task }: StepFacts): NextStep {
  const run = t('bar.run');
  if (isGreeted) return step('press', 'plain', t(words.press, { run }), t(words.firstDrive));
  if (task === null) return step('ready', 'plain', t(words.ready), t(words.pressRun, { run }));
  return step('ready', 'plain', t(words.ready), task.wanted, action('run', t(words.go), true));
}

/** A verdict, with what follows from it. */
function decidedStep(task: StepTask): NextStep | null {
  const { state, told } = task;
  if (state === 'passed') return step('done', 'done', t('verdict.passed'), told, afterwards(task));
  if (state === 'checking') return step('checking', 'plain', t(words.goalReached), told);
  // Whoever knows how it goes needs no hint: the same once more, without help.
  if (state === 'helped') return step('helped', 'notYet', task.news, told, action('again', t('verdict.again')));
  return notYet(task, told);
}

function afterwards({ kind, next, isHandedIn }: StepTask): StepButton | null {
  if (kind === 'given')
    return isHandedIn ? action('hand-in', t('bar.handInAgain')) : action('hand-in', t(words.handIn), true);
  if (kind === 'own') return action('again', t('verdict.again'));
  return next === null ? null : action(next, t(words.next[next]), next !== 'missions');
}

/** Not done: the reason, and the next hint while there is one: those written on the card first. */
function notYet({ hints, own }: StepTask, reason: string): NextStep {
  const [name, { open, all }] = hints.open < hints.all ? (['hint', hints] as const) : (['own-hint', own] as const);
  const text = open === 0 ? t(words.hint) : t(words.hintNumber, { number: open + 1 });
  return step('notYet', 'notYet', t('verdict.notYet'), reason, open < all ? action(name, text) : null);
}

function errorStep({ line }: { readonly line: number | null }, isPhone: boolean): NextStep {
  const title = line === null ? t(words.error) : t(words.errorIn, { line });
  // A wide page has the repair in sight, a phone behind the tab with the program.
  if (!isPhone) return step('error', 'error', title, t(words.errorHelp));
  return step('error', 'error', title, t(words.errorHelpBelow), action('change', t(words.change), true));
}

const action = (name: StepAction, text: string, isInk = false): StepButton => ({ action: name, text, isInk });

const step = (
  kind: StepKind,
  tone: StepTone,
  title: string,
  reason: string,
  button: StepButton | null = null,
): NextStep => ({ kind, tone, sign: SIGNS[kind], title, reason, button });
