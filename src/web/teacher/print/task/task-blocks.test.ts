import { describe, expect, it } from 'vitest';

import type { PaperBlock } from './set-rows';
import { taskBlocks, type PaperTask } from './task-blocks';

const task: PaperTask = {
  ...{ title: 'Der Slalom', text: 'Fahre.', picture: null, goalsTitle: 'Das ist das Ziel' },
  ...{ goals: [], rules: [], checksTitle: 'Ausserdem geprüft', checks: [], stars: [], hints: [] },
};

/** Each block as its sign and its words. */
const said = (blocks: readonly PaperBlock[]): string[] =>
  blocks.map((block) => {
    if (block.kind === 'picture') return `[${block.size.map(Math.round).join(' × ')}]`;
    const { sign, lines } = block;
    const mark = sign === null ? '' : `${sign.kind === 'mark' ? sign.text : sign.kind === 'ring' ? 'o' : '*'.repeat(sign.count)} `; // prettier-ignore
    return mark + lines.map((line) => line.map(({ text }) => text).join('')).join(' / ');
  });
const blocksOf = (part: Partial<PaperTask>): string[] => said(taskBlocks({ ...task, ...part }, 170));

describe('the task on paper', () => {
  it('has its title, its text with lists, then what is to be reached and kept to, and the stars', () => {
    const text = 'Fahre **los**,\nimmer weiter.\n\n- um das Tor\n- ins `Ziel`\n\n1. rechts\n2. links';
    const rest = { goals: ['Erreiche das Ziel'], rules: ['nichts berühren'], stars: ['geschafft', 'unter 9 s'] };
    expect(blocksOf({ text, ...rest })).toEqual([
      ...['Der Slalom', 'Fahre los, / immer weiter.', '• um das Tor', '• ins Ziel', '1. rechts', '2. links'],
      ...['Das ist das Ziel', 'o Erreiche das Ziel', '• nichts berühren', '* geschafft', '** unter 9 s'],
    ]);
  });

  it('has what else is checked behind the goals', () => {
    expect(blocksOf({ goals: ['Erreiche das Ziel'], checks: ['nutzt eine Schleife (1 Punkt)'] }).slice(2)).toEqual([
      ...['Das ist das Ziel', 'o Erreiche das Ziel', 'Ausserdem geprüft', '• nutzt eine Schleife (1 Punkt)'],
    ]);
  });

  it('has no heading over goals that there are not', () => {
    expect(blocksOf({})).toEqual(['Der Slalom', 'Fahre.']);
  });

  it('has the hints where they are wanted, each under its name', () => {
    expect(blocksOf({ hints: [{ title: 'Tipp 1', text: 'Erst\n\ndann' }] }).slice(2)).toEqual([
      'Tipp 1',
      'Erst',
      'dann',
    ]);
  });

  it('has its picture where the text says, otherwise behind it; none leaves no gap', () => {
    const picture = { data: '', format: 'PNG', size: [320, 200] } as const; // 84.7 × 52.9 mm at 96 pixels an inch
    const text = 'eins\n\n![Plan](picture)\n\nzwei';
    expect(blocksOf({ text, picture })).toEqual(['Der Slalom', 'eins', '[85 × 53]', 'zwei']);
    expect(blocksOf({ picture })).toEqual(['Der Slalom', 'Fahre.', '[85 × 53]']);
    expect(blocksOf({ text })).toEqual(['Der Slalom', 'eins', 'zwei']);
  });

  it('shrinks a picture that is wider than the sheet or higher than a third of it', () => {
    const wide = { data: '', format: 'PNG', size: [1700, 200] } as const;
    const high = { data: '', format: 'PNG', size: [200, 1100] } as const;
    expect(blocksOf({ picture: wide }).at(-1)).toBe('[170 × 20]');
    expect(blocksOf({ picture: high }).at(-1)).toBe('[20 × 110]');
  });
});
