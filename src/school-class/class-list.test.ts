import { describe, expect, it } from 'vitest';

import { addResults } from './add-results';
import { namesIn, namesTwice, withList, withPupilsJoined } from './class-list';
import { newClass, type SchoolClass } from './school-class';
import { aResult, aTask, found } from './testing/class';

describe('the list of a class', () => {
  it.each([
    ['one name a line', 'Ada Meier\nBen Huber\n\n', ['Ada Meier', 'Ben Huber']],
    ['numbered', '1. Ada Meier\r\n2. Ben Huber', ['Ada Meier', 'Ben Huber']],
    ['last name, first name', 'Meier, Ada\nHuber, Ben', ['Ada Meier', 'Ben Huber']],
    [
      'a table without headings',
      '1\tMeier\tAda\tada@schule.ch\n2\tHuber\tBen\tben@schule.ch',
      ['Ada Meier', 'Ben Huber'],
    ],
    ['German headings', 'Nr.;Vorname;Name;Klasse\n1;Ada;Meier;8b', ['Ada Meier']],
    ['French headings', '"Nom","Prénom"\n"Favre","Anouk"', ['Anouk Favre']],
    ['Italian headings', 'Cognome\tNome\nRossi\tLuca', ['Luca Rossi']],
    ['English headings of Moodle', '"First name","Last name","Email address"\nAda,Meier,a@b.ch', ['Ada Meier']],
    ['a comma inside quotes', 'Name;Klasse\n"Meier, Ada";8b', ['Meier, Ada']],
    ['nothing', ' \n1\n', []],
  ])('is read from %s', (_, text, names) => expect(namesIn(text)).toEqual(names));

  it('says which names are in it twice', () => expect(namesTwice(['Ada', 'Ben', 'Ada', 'Ada'])).toEqual(['Ada']));

  const handedIn = addResults(newClass('8b'), {
    task: aTask('bend'),
    found: found('The bend', { meier_ada: aResult(4), Noah: aResult(2), 'Ada M': aResult(3), Zoe: aResult(1) }),
    day: '2026-11-02',
  }).schoolClass;
  const namesOf = ({ pupils }: SchoolClass): readonly string[] => pupils.map(({ name, isListed }) => `${name}${isListed ? '' : '?'}`); // prettier-ignore

  it('takes over who has handed in already, and keeps those whom nobody knows behind it', () => {
    const listed = withList(handedIn, ['Ada Meier', 'Noah Keller', 'Noah Kunz', 'Ben Huber']);
    expect(namesOf(listed)).toEqual(['Ada Meier', 'Noah Keller', 'Noah Kunz', 'Ben Huber', 'Noah?', 'Zoe?']);
    const ada = listed.pupils[0]!;
    expect(ada.also).toEqual(['meier_ada']);
    expect(listed.results.filter(({ pupil }) => pupil === ada.id).map(({ points }) => points)).toEqual([4, 3]);
    const one = withPupilsJoined(listed, listed.pupils[2]!.id, listed.pupils[4]!.id);
    expect(namesOf(one)).toEqual(['Ada Meier', 'Noah Keller', 'Noah Kunz', 'Ben Huber', 'Zoe?']);
    expect(one.results.find(({ points }) => points === 2)!.pupil).toBe(listed.pupils[2]!.id);
    expect(one.results).toHaveLength(4);
  });

  it('can be pasted again, also with two of one name, and changes nothing', () => {
    const names = ['Ada Meier', 'Noah Kunz', 'Noah Kunz'];
    const once = withList(newClass('8b'), names);
    expect(once.pupils.map(({ id }) => id)).toEqual(['ada-meier', 'kunz-noah', 'kunz-noah-2']);
    expect(withList(once, names)).toEqual(once);
  });
});
