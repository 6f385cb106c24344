import { describe, expect, it } from 'vitest';
import { webLayers, wings } from '../layers.mjs';
import { folderCircles, forbiddenBetween, graphOf, importsOf, styleImportsIn, waysTo } from './layers.mjs';

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
      ['web/app/x.ts', 'web/kit/y.ts'],
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

describe('a stylesheet', () => {
  const component = '<style scoped src="../work/own.css"></style>\n<style>\n@import "./near.css";\n</style>';
  const imports = styleImportsIn('src/web/session/task/Card.vue', component);

  it('is an import of the component that takes it in, by address or by name', () => {
    expect(imports).toEqual([
      ['src/web/session/task/Card.vue', 'src/web/session/work/own.css'],
      ['src/web/session/task/Card.vue', 'src/web/session/task/near.css'],
    ]);
    expect(styleImportsIn('src/web/kit/all.css', '@import url(./one.css);\nb { color: red; }')).toEqual([
      ['src/web/kit/all.css', 'src/web/kit/one.css'],
    ]);
  });

  it('may be taken in from another room only if the table allows it', () => {
    const rooms = (table) => forbiddenBetween(imports, { folder: 'src/web', table });
    expect(rooms({ 'session/task': ['session/work'], 'session/work': [] })).toEqual([]);
    expect(rooms({ 'session/task': ['session'], 'session/work': [] })).toEqual([]);
    expect(rooms({ 'session/task': [], 'session/work': [] })).toEqual([
      'src/web/session/task/Card.vue → src/web/session/work/own.css\n    session/task may import nothing (layers.mjs)',
    ]);
  });

  it('ties a circle between folders as any import does', () => {
    const back = [['src/web/session/work/x.ts', 'src/web/session/task/y.ts']];
    expect(folderCircles([...imports, ...back], 'src/web')).toEqual(['src/web/session/task ↔ src/web/session/work']);
  });
});

describe('a room of the page', () => {
  const order = Object.keys(wings);
  const wingOf = (room) => room.split('/')[0];

  it.each(Object.entries(webLayers))('%s reaches no wing behind its own', (room, allowed) => {
    for (const other of allowed) expect(order.indexOf(wingOf(other))).toBeLessThanOrEqual(order.indexOf(wingOf(room)));
  });

  it.each(Object.entries(webLayers))('%s reaches rooms that exist', (_room, allowed) => {
    for (const other of allowed) expect(other in webLayers || other in wings, other).toBe(true);
  });
});

describe('the ways of imports to a file', () => {
  const modules = [
    { source: 'page.ts', dependencies: [{ resolved: 'card.ts' }, { resolved: 'fact.ts' }] },
    {
      source: 'card.ts',
      dependencies: [{ resolved: 'page.ts' }, { resolved: 'run.ts', dependencyTypes: ['type-only'] }],
    },
    { source: 'fact.ts', dependencies: [{ resolved: 'run.ts', dependencyTypes: ['dynamic-import'] }] },
    { source: 'fact.test.ts', dependencies: [{ resolved: 'run.ts' }] },
  ];

  it('lead from importer to importer, also by what is fetched later, and past a circle', () => {
    expect([...waysTo('run.ts', modules)]).toEqual([
      ['run.ts', ['run.ts']],
      ['fact.ts', ['fact.ts', 'run.ts']],
      ['page.ts', ['page.ts', 'fact.ts', 'run.ts']],
      ['card.ts', ['card.ts', 'page.ts', 'fact.ts', 'run.ts']],
    ]);
  });

  it('are made neither of types nor of tests', () => {
    expect([
      ...waysTo(
        'run.ts',
        modules.filter(({ source }) => source !== 'fact.ts'),
      ).keys(),
    ]).toEqual(['run.ts']);
  });
});
