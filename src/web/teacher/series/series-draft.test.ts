import { describe, expect, it } from 'vitest';

import { seriesLimits, type Series } from '#check/series/series';
import { aSeries } from '#check/series/testing/series';

import { LateModels } from '../../kit/state/late-models';
import { emptySeries, seriesDraft } from './series-draft';

const draftOf = (series: Series) => {
  const draft = seriesDraft({ late: new LateModels() });
  draft.replace(series);
  return draft;
};
const idsIn = ({ series }: { readonly series: { readonly value: Series } }): readonly string[] =>
  series.value.tasks.map(({ id }) => id);
const [first] = aSeries().tasks;

describe('the series that a teacher is making', () => {
  it('belongs to one page, where whoever asks gets the same', () => {
    const page = { late: new LateModels() };
    seriesDraft(page).change({ title: 'Woche 4' });
    expect(seriesDraft(page).series.value.title).toBe('Woche 4');
    expect(seriesDraft({ late: new LateModels() }).series.value.title).toBe('');
  });

  it('begins with an id of eight digits of its own, without title and tasks', () => {
    const [one, other] = [emptySeries(), emptySeries()];
    expect(one).toEqual({ id: expect.stringMatching(/^[0-9a-f]{8}$/) as string, title: '', text: '', tasks: [] });
    expect(one.id).not.toBe(other.id);
  });

  it('gives each added task an id that no other has, so that their marks stay apart', () => {
    const draft = draftOf(aSeries());
    expect(draft.add([first!, first!])).toBe(0);
    expect(new Set(idsIn(draft)).size).toBe(5);
    expect(idsIn(draft).slice(0, 3)).toEqual(['1', 'b', '3']);
  });

  it('takes as many tasks as a series may have, and says how many had no room', () => {
    const draft = draftOf(emptySeries());
    const many = Array.from({ length: seriesLimits.tasks.max + 2 }, () => first!);
    expect(draft.add(many)).toBe(2);
    expect(idsIn(draft)).toHaveLength(seriesLimits.tasks.max);
    expect(draft.add([first!])).toBe(1);
  });

  it('has its tasks moved up and down, but not beyond its ends', () => {
    const draft = draftOf(aSeries());
    expect([draft.move(2, -1), idsIn(draft)]).toEqual([1, ['1', '3', 'b']]);
    expect([draft.move(0, -1), idsIn(draft)]).toEqual([0, ['1', '3', 'b']]);
    expect([draft.move(2, 1), idsIn(draft)]).toEqual([2, ['1', '3', 'b']]);
  });

  it('keeps its id when its title changes or a task goes: marks of pupils hold on', () => {
    const draft = draftOf(aSeries());
    draft.change({ title: 'Neu' });
    draft.remove(1);
    expect(draft.series.value).toEqual({ ...aSeries(), title: 'Neu', tasks: aSeries().tasks.toSpliced(1, 1) });
  });
});
