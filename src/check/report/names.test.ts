import { describe, expect, it } from 'vitest';

import { nameOrder, shownNames } from './names';

describe('the names of hand-ins', () => {
  it('are shown without what a platform has added, and told apart where a pupil has two', () => {
    const names = [
      'Weiss Tim_10231_assignsubmission_file_',
      'Ärni Sofia_10233_assignsubmission_onlinetext_',
      'Weiss Tim_10231_assignsubmission_onlinetext_',
      'Roth Jo_3_assignsubmission_file_Projekt main',
      'anna_meier',
    ];
    expect(shownNames(names)).toEqual(['Weiss Tim', 'Ärni Sofia', 'Weiss Tim (2)', 'Roth Jo', 'anna_meier']);
    expect(shownNames(['Eva_1_assignsubmission_file_', 'Eva'])).toEqual(['Eva (2)', 'Eva']);
  });

  it('stand as the language sorts them and people count, always the same', () => {
    const names = ['Zwei', 'Bonnet', 'Ärni', 'Bérard', 'Anna 10', 'Anna 9', 'Zoë', 'Zoe'];
    const sorted = ['Anna 9', 'Anna 10', 'Ärni', 'Bérard', 'Bonnet', 'Zoe', 'Zoë', 'Zwei'];
    for (const language of ['de', 'fr', 'it', 'en']) expect(names.toSorted(nameOrder(language))).toEqual(sorted);
    expect(['a\u0301', 'á'].toSorted(nameOrder('de'))).toEqual(['á', 'a\u0301'].toSorted(nameOrder('de')));
  });
});
