import { describe, expect, it } from 'vitest';
import { folderCircles, forbiddenBetween, graphOf, importsOf, styleImportsIn } from './layers.mjs';

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

describe('a stylesheet', () => {
  const component = '<style scoped src="../work/own.css"></style>\n<style>\n@import "./near.css";\n</style>';
  const imports = styleImportsIn('src/web/task/Card.vue', component);

  it('is an import of the component that takes it in, by address or by name', () => {
    expect(imports).toEqual([
      ['src/web/task/Card.vue', 'src/web/work/own.css'],
      ['src/web/task/Card.vue', 'src/web/task/near.css'],
    ]);
    expect(styleImportsIn('src/web/page/all.css', '@import url(./one.css);\nb { color: red; }')).toEqual([
      ['src/web/page/all.css', 'src/web/page/one.css'],
    ]);
  });

  it('of another room is taken in only where the table allows it', () => {
    const rooms = (table) => forbiddenBetween(imports, { folder: 'src/web', table });
    expect(rooms({ task: ['work'], work: [] })).toEqual([]);
    expect(rooms({ task: [], work: [] })).toEqual([
      'src/web/task/Card.vue → src/web/work/own.css\n    task may import nothing (layers.mjs)',
    ]);
  });

  it('ties a circle between folders as any import does', () => {
    const back = [['src/web/work/x.ts', 'src/web/task/y.ts']];
    expect(folderCircles([...imports, ...back], 'src/web')).toEqual(['src/web/task ↔ src/web/work']);
  });
});
