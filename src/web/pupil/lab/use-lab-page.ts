import { computed, shallowRef } from 'vue';

import { passedOf } from '#lab/sweep-texts';

import { t } from '../../kit/i18n';
import { usePage } from '../../kit/parts';
import { useLayout } from '../../session/layout/parts';
import { useRun } from '../../session/run/parts';
import { useWork } from '../../session/work/model/parts';
import { isStale } from './act-on-run';
import { ROBOTS, type LabRun, type Series } from './model/lab-model';
import { meaningOf } from './model/meaning';
import { firstRange, numberThings, otherThings } from './model/things';
import { timeText, valueText } from './say';
import { labOf } from './use-lab';
import words from './words';

/** The subjects of the page: one thing, two things, or used robots. */
export const LAB_KINDS = ['one', 'two', 'robots'] as const;
export type LabKind = (typeof LAB_KINDS)[number];

/** The kind of a series. */
const kindOf = ({ wish }: Series): LabKind =>
  wish.kind === 'robots' ? 'robots' : wish.ranges.length > 1 ? 'two' : 'one';

/** Simulated time of a run before one was made, in ms. */
const USUAL_MS = 10_000;

/** The state of the page of experiments. */
export function useLabPage() {
  const app = { ...usePage(), ...useWork(), ...useRun(), ...useLayout() };
  const lab = labOf(app);
  const series = computed(() => lab.series.value);
  const runs = computed(() => lab.inOrder.value);
  const base = computed(() => lab.base().setup);
  const things = computed(() => [...numberThings(base.value), ...otherThings(base.value)]);
  /** The thing that the address names, such as `#lab/main.py:5`. */
  const named = computed(() => things.value.find(({ name }) => name === app.router.idOn('lab')) ?? null);
  if (lab.failure.value === 'unclear') lab.failure.value = null;
  const chosenKind = shallowRef<LabKind>(series.value === null || named.value ? 'one' : kindOf(series.value));
  const isAsking = shallowRef(series.value === null || named.value !== null);
  const first = computed(() => {
    if (named.value !== null && chosenKind.value === 'one') return [firstRange(named.value)];
    const wish = lab.wishNow();
    const count = chosenKind.value === 'two' ? 2 : 1;
    const asked = wish?.kind === 'ranges' ? wish.ranges.slice(0, count) : [];
    const more = things.value.filter(({ name }) => asked.every((range) => range.name !== name));
    const added = more.slice(0, count - asked.length).map(firstRange);
    return [...asked, ...(count === 2 ? added.map((range) => ({ ...range, step: range.step * 5 })) : added)];
  });
  const estimateMs = (count: number): number =>
    lab.estimateMs(count, (app.run.present.value?.timeUs ?? 0) / 1000 || USUAL_MS);

  /** The values in the program, of what varies. */
  const now = computed(() => {
    const { taken } = lab;
    const run = taken.value === null ? null : (series.value?.runs.get(taken.value) ?? null);
    const wish = run === null ? lab.wishNow() : null;
    const names = wish?.kind === 'ranges' ? wish.ranges.map(({ name }) => name) : [];
    return (series.value?.sweep.varied ?? []).map((_, place) =>
      run === null ? (things.value.find((one) => one.name === names[place])?.now ?? null) : Number(run.values[place]),
    );
  });
  const stale = computed(() => isStale(lab));

  function show(kind: LabKind): void {
    chosenKind.value = kind;
    isAsking.value = series.value === null || kindOf(series.value) !== kind;
  }
  function choose(run: LabRun): void {
    const all = series.value?.runs ?? new Map<number, LabRun>();
    lab.chosen.value = [...all].find(([, one]) => one === run)?.[0] ?? null;
  }
  function step(by: number): void {
    const at = lab.chosenRun.value === null ? -1 : runs.value.indexOf(lab.chosenRun.value);
    const run = runs.value[at + by];
    if (run !== undefined) choose(run);
  }
  return {
    ...{ app, lab, series, runs, chosenKind, isAsking, things, first, estimateMs, now, stale, show, choose, step },
    ...labSentences(lab, series, runs),
  };
}

/** The sentences of the page about a series. */
function labSentences(
  lab: ReturnType<typeof labOf>,
  series: Readonly<{ value: Series | null }>,
  runs: Readonly<{ value: readonly LabRun[] }>,
) {
  const result = computed(() => {
    const [passed, of] = [passedOf(lab.result()), runs.value.length];
    if (series.value === null) return '';
    if (lab.isRunning.value) return t(words.progress, { done: of, of: series.value.sweep.count });
    if (series.value.wish.kind === 'robots' && series.value.hasTask) return t(words.robotsOf, { passed, of });
    return t(series.value.hasTask ? words.passedOf : words.ranOf, { passed, of });
  });
  const beside = computed(() => {
    if (series.value === null) return '';
    if (lab.isRunning.value) return series.value.wish.kind === 'robots' ? '' : t(words.coarse);
    const values = { done: runs.value.length, of: series.value.sweep.count };
    return t(words.tookRuns, { ...values, time: timeText(lab.tookMs.value) });
  });
  const meaning = computed(() => {
    const { sweep, wish } = series.value ?? {};
    if (sweep === undefined || runs.value.length === 0) return '';
    if (wish?.kind === 'robots') return t(words.meaning.robots);
    const [passed, of] = [passedOf(lab.result()), runs.value.length];
    if (sweep.varied.length > 1) return series.value?.hasTask ? t(words.meaning.map, { passed, of }) : '';
    const found = meaningOf(runs.value);
    if (found === null) return '';
    const said = t(words.meaning[found.kind], { from: valueText(found.from), to: valueText(found.to) });
    const faster = found.faster === null || lab.isRunning.value ? '' : ` ${t(words.meaning[found.faster])}`;
    return (lab.isRunning.value ? t(words.meaning.soFar) : '') + said + faster;
  });
  return { result, beside, meaning, robots: ROBOTS };
}
