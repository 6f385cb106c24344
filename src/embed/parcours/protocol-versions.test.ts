import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import { commandNames } from './command-schemas';
import { eventNames } from './event-schemas';
import { protocolChanges } from './protocol-versions';

describe('the versions of our own dialect', () => {
  it('hold every command and every event exactly once', () => {
    const all = (kind: 'commands' | 'events'): string[] =>
      protocolChanges.flatMap((change) => [...change[kind]]).sort();
    expect(all('commands')).toEqual([...commandNames].sort());
    expect(all('events')).toEqual([...eventNames].sort());
  });

  it('are listed in the manual with each name that they brought after the first', () => {
    const manual = readFileSync('docs/embedding.md', 'utf8');
    const chapter = /^### Changes of our own dialect\n([^]*?)\n#/m.exec(manual)?.[1] ?? '';
    for (const { app, commands, events } of protocolChanges.slice(1))
      for (const word of [app, ...commands, ...events]) expect(chapter, word).toContain(`\`${word}\``);
  });
});
