import { describe, expect, it } from 'vitest';

import { withList } from './class-list';
import { findPupil } from './names';
import { newClass } from './school-class';

const { pupils } = withList(newClass('8b'), [
  ...['Ada Meier', 'Björn Müller', 'Anna-Lena Roth', 'Noah Keller', 'Noah Kunz', 'D’Angelo Rossi', 'Nguyễn Anh', 'Lea'],
]);
const whose = (name: string): string | undefined => findPupil(pupils, name)?.name;

describe('a name on a hand-in', () => {
  it.each([
    ['Ada Meier', 'Ada Meier'],
    ['meier_ada', 'Ada Meier'],
    ['MEIER Ada (2)', 'Ada Meier'],
    ['Ada M.', 'Ada Meier'],
    ['ada', 'Ada Meier'],
    ['Meier Ada_10231_assignsubmission_file_', 'Ada Meier'],
    ['Ada Sophie Meier', 'Ada Meier'],
    ['bjoern.mueller', 'Björn Müller'],
    ['Mu\u0308ller Bjo\u0308rn', 'Björn Müller'],
    ['Anna Lena Roth', 'Anna-Lena Roth'],
    ['noah-keller', 'Noah Keller'],
    ['Noah Ke', undefined],
    ['Noah', undefined],
    ['dangelo rossi', 'D’Angelo Rossi'],
    ['Anh Nguyen', 'Nguyễn Anh'],
    ['Lea', 'Lea'],
    ['Lea Huber', undefined],
    ['main', undefined],
    ['l', undefined],
    ['123', undefined],
  ])('%j is that of %s', (name, pupil) => expect(whose(name)).toBe(pupil));

  it('that is a number is that of whoever is kept under this number', () => {
    const numbered = [...pupils, { id: 'pupil', name: '07', also: [], isListed: false }];
    expect(['07', '7', 'Lea'].map((name) => findPupil(numbered, name)?.name)).toEqual(['07', undefined, 'Lea']);
  });
});
