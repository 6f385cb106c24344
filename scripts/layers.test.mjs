import { describe, expect, it } from 'vitest';
import { folderCircles, graphOf, importsOf } from './layers.mjs';

describe('folders that import each other', () => {
  it('are found, also over a third one', () => {
    const imports = [
      ['web/a/x.ts', 'web/b/y.ts'],
      ['web/b/y.ts', 'web/c/z.ts'],
      ['web/c/z.ts', 'web/a/w.ts'],
      ['web/d/v.ts', 'web/a/x.ts'],
    ];
    expect(folderCircles(imports, 'web')).toEqual(['web/a ↔ web/b ↔ web/c']);
  });

  it('are none where imports only go down, and where a picture is fetched from above', () => {
    const imports = [
      ['web/app/x.ts', 'web/page/y.ts'],
      ['web/main.ts', 'web/app/x.ts'],
      ['web/app/x.ts', 'web/logo.svg'],
    ];
    expect(folderCircles(imports, 'web')).toEqual([]);
  });
});

describe('the graph of the rooms', () => {
  it('shows who imports whom, without tests and without the floor', () => {
    const imports = importsOf([
      { source: 'src/b/x.ts', dependencies: [{ resolved: 'src/a/y.ts' }, { resolved: 'src/core/z.ts' }] },
      { source: 'src/a/y.test.ts', dependencies: [{ resolved: 'src/b/x.ts' }] },
    ]);
    const graph = graphOf(imports, { folder: 'src', table: { core: [], a: [], b: [] }, floor: 'core' });
    expect(graph.split('\n')).toEqual(['```mermaid', 'flowchart TD', '  b --> a', '```', '']);
  });
});
