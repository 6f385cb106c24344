import { computed, onScopeDispose, shallowRef, watch } from 'vue';

import { robotTypes } from '#robots/index';
import type { DeviceSnapshot, Snapshot } from '#simulation/snapshot';

import { shownLanguage, t } from '../../kit/i18n';
import type { WithLate } from '../../kit/state/late-models';
import { fillInSilently, useFilled } from '../../session/run/fill/fill-in';
import type { RunParts } from '../../session/run/parts';
import { realBoard, type RealBoard } from '../../session/run/board/real-board';
import type { WorkParts } from '../../session/work/model/parts';
import words from './series/words';
import { canJoin, chosenCurves, drawable } from './chosen-curves';
import type { Curve } from './plot/chart-plot';
import { lookAt } from './plot/looks';
import type { Span } from './plot/span';
import { PrintedSource } from './series/printed-source';
import { readingsOf, usualReadings } from './series/readings';
import { noPoints, type Series, type SeriesSource } from './series/series';
import { TapeSource } from './series/tape-source';

/** Shortest time between two drawings of the curves during a run, in ms; one more for so many points. */
const LEAST_MS = 60;
const POINTS_PER_MS = 200; // chosen: then drawing takes less than a tenth of the time on the slow tablet

/** A kind of curves in the list, with those that can be chosen. */
export interface CurveGroup {
  readonly title: string;
  readonly entries: readonly { readonly series: Series; readonly isChosen: boolean; readonly canChoose: boolean }[];
}

/** The curves of the run for as long as the component lives. */
export function useChart(app: Pick<RunParts, 'run'> & Pick<WorkParts, 'work'> & WithLate) {
  const { run, work } = app;
  const chosenIds = chosenCurves(app);
  const board = realBoard(app);
  let sources: Sources = { printed: [], all: [], usual: [] };
  let timer: ReturnType<typeof setTimeout> | undefined;
  const curves = shallowRef<readonly Curve[]>([]);
  const groups = shallowRef<readonly CurveGroup[]>([]);
  const isReading = shallowRef(false);

  function update(): void {
    clearTimeout(timer);
    timer = undefined;
    for (const printed of sources.printed) printed.update(); // what was printed is known once it was taken in: the choice comes after it
    const lists = sources.all.map((source) => ({ source, list: source.list() }));
    const drawn = drawable(chosenIds.value ?? usualOf(sources), lists.flatMap(({ list }) => list)); // prettier-ignore
    const ids = new Set(drawn.map(({ id }) => id));
    isReading.value = sources.all.map((source) => source.update(ids)).some((isMore) => isMore);
    const sourceOf = (series: Series) => lists.find(({ list }) => list.includes(series))?.source;
    curves.value = drawn.map((series, place) => ({
      ...{ series, look: lookAt(place) },
      points: sourceOf(series)?.pointsOf(series.id) ?? noPoints,
    }));
    groups.value = lists.flatMap(({ source, list }) => (list.length > 0 ? [groupOf(source.title(), list, drawn)] : []));
    if (isReading.value) timer = setTimeout(update);
  }
  function updateSoon(): void {
    const points = curves.value.reduce((sum, curve) => sum + curve.points.timesS.length, 0);
    timer ??= setTimeout(update, LEAST_MS + points / POINTS_PER_MS);
  }
  /** The robot's type and the number of its servos, which come to it when they are first used. */
  const things = computed(() => {
    const device = deviceAt(run.present.value, work.place.value);
    return device && [device.robot?.type, Object.keys(device.robot?.state.servos ?? {}).length].join(' ');
  });
  watch(
    [run.recording, work.place, things, shownLanguage, board, () => board.value?.start.value],
    () => {
      sources = sourcesOf(app, board.value);
      update();
    },
    { immediate: true },
  );
  watch([run.present, () => run.recording.value.count.value, () => board.value?.count.value], updateSoon);
  useFilled(() => run.recording.value, (tape) => fillInSilently(tape, run)); // prettier-ignore
  watch(chosenIds, update);
  onScopeDispose(() => clearTimeout(timer));

  const whole = computed((): Span => [0, Math.max(1, ...curves.value.map(({ points }) => points.timesS.at(-1) ?? 0))]);
  function toggle(id: string): void {
    const drawn = curves.value.map(({ series }) => series.id);
    chosenIds.value = drawn.includes(id) ? drawn.filter((it) => it !== id) : [...drawn, id];
  }
  return { curves, groups, whole, isReading, toggle };
}

/** The sources of a device's curves, and the readings drawn by default. */
interface Sources {
  /** The numbers that the program prints in the run, and those that it prints on a real board. */
  readonly printed: readonly PrintedSource[];
  readonly all: readonly SeriesSource[];
  readonly usual: readonly string[];
}

function sourcesOf({ run, work }: Pick<RunParts, 'run'> & Pick<WorkParts, 'work'>, board: RealBoard | null): Sources {
  const device = work.place.value;
  const shown = deviceAt(run.present.value, device);
  const type = robotTypes.find(({ id }) => id === shown?.robot?.type);
  const readings = shown === null ? [] : readingsOf(shown, type);
  const recording = run.recording.value;
  const unnamed = (place: number): string => (place === 0 ? t(words.output) : t(words.outputOf, { place }));
  const taped = () => ({ pieces: recording.pieces, present: run.present.value });
  const here = new PrintedSource(() => t(words.printed), () => recording, device, unnamed); // prettier-ignore
  const printed = board === null ? [here] : [here, printedOn(board, unnamed)];
  return { printed, all: [...printed, new TapeSource(() => t(words.robot), readings, device, taped)], usual: usualReadings(readings) }; // prettier-ignore
}

/** The numbers that a real board's program prints, from its start on, as a run's are from its own. */
function printedOn(board: RealBoard, unnamed: (place: number) => string): PrintedSource {
  const name = board.name.value;
  return new PrintedSource(() => t(words.printedOn, { board: name }), () => board, 0, unnamed, {
    id: 'board',
    named: (curve) => t(words.curveOn, { name: curve, board: name }),
  }); // prettier-ignore
}

const deviceAt = (snapshot: Snapshot | null, device: number): DeviceSnapshot | null =>
  device === 0 ? snapshot : (snapshot?.others[device - 1] ?? null);

/** The curves drawn by default: those that the program prints, else the usual readings. */
function usualOf({ printed, usual }: Sources): readonly string[] {
  const ids = printed.flatMap((source) => source.list().map(({ id }) => id));
  return ids.length > 0 ? ids : usual;
}

const groupOf = (title: string, list: readonly Series[], drawn: readonly Series[]): CurveGroup => ({
  title,
  entries: list.map((series) => ({
    series,
    isChosen: drawn.includes(series),
    canChoose: drawn.includes(series) || canJoin(series, drawn),
  })),
});
