import { describe, expect, it } from 'vitest';
import { elementsOf, readSvgTree } from './svg-tree';

describe('an SVG text', () => {
  it('is read into a tree that knows where each element starts and ends', () => {
    const text = '<svg><!-- <g> --><g id="a"><path d="M0>1"/></g><rect/></svg>';
    const elements = [...elementsOf(readSvgTree(text))];
    expect(elements.map(({ name }) => name)).toEqual(['#document', 'svg', 'g', 'path', 'rect']);
    const group = elements[2]!;
    expect(text.slice(group.start, group.end)).toBe('<g id="a"><path d="M0>1"/></g>');
  });

  it('is read to its end with an element that is never closed', () => {
    expect([...elementsOf(readSvgTree('<svg><g>'))]).toHaveLength(3);
  });
});
