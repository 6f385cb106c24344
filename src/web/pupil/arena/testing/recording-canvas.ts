import { vi } from 'vitest';

import type { Vec } from '#core/geometry';

/** Something that became visible on the canvas. */
export interface Painted {
  readonly by: 'fill' | 'stroke' | 'text';
  readonly color: string;
  readonly alpha: number;
  /** Bounds of the path, without the width of its line; in px of the canvas. */
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  /** Width of the line in px. */
  readonly line: number;
  /** True if the line is dashed. */
  readonly dashed: boolean;
  /** The words, for `text`. */
  readonly text: string;
}

interface State {
  fillStyle: string;
  strokeStyle: string;
  lineWidth: number;
  globalAlpha: number;
  dash: readonly number[];
  /** a b c d e f, as of a DOMMatrix. */
  matrix: readonly [number, number, number, number, number, number];
}

const START: State = {
  fillStyle: '#000000',
  strokeStyle: '#000000',
  lineWidth: 1,
  globalAlpha: 1,
  dash: [],
  matrix: [1, 0, 0, 1, 0, 0],
};

/** A replacement of `Path2D`, known by its outline in SVG. Node has none. */
export class NodePath {
  readonly points: Vec[] = [];
  constructor(readonly outline: string = '') {
    // Icons have 24 units.
    if (outline !== '') this.points.push({ x: 0, y: 0 }, { x: 24, y: 24 });
  }
  readonly moveTo = (x: number, y: number): void => void this.points.push({ x, y });
  readonly lineTo = (x: number, y: number): void => void this.points.push({ x, y });
  readonly quadraticCurveTo = (_x: number, _y: number, x: number, y: number): void => void this.points.push({ x, y });
  readonly closePath = (): void => undefined;
}

/** A canvas context that records everything painted, with colour and place; it supports transformations. */
export class RecordingCanvas {
  readonly painted: Painted[] = [];
  private state: State = { ...START };
  private readonly stack: State[] = [];
  private path: Vec[] = [];

  /** The canvas as a context for the drawing functions. */
  get context(): CanvasRenderingContext2D {
    return new Proxy(this, {
      get: (canvas, name) => {
        if (name in canvas.state) return canvas.state[name as keyof State];
        const own: unknown = Reflect.get(canvas, name);
        return typeof own === 'function' ? (own as (...all: unknown[]) => unknown).bind(canvas) : () => undefined;
      },
      set: (canvas, name, value) => {
        canvas.state = { ...canvas.state, [name]: value };
        return true;
      },
    }) as unknown as CanvasRenderingContext2D;
  }

  /** Everything that was painted in this colour. */
  in(color: string): readonly Painted[] {
    return this.painted.filter((one) => one.color === color);
  }

  /** The words that were written, each once. */
  get words(): readonly string[] {
    return [...new Set(this.painted.filter(({ by }) => by === 'text').map(({ text }) => text))];
  }

  save(): void {
    this.stack.push(this.state);
  }
  restore(): void {
    this.state = this.stack.pop() ?? this.state;
  }
  translate(x: number, y: number): void {
    this.transform([1, 0, 0, 1, x, y]);
  }
  scale(x: number, y: number): void {
    this.transform([x, 0, 0, y, 0, 0]);
  }
  rotate(rad: number): void {
    const [cos, sin] = [Math.cos(rad), Math.sin(rad)];
    this.transform([cos, sin, -sin, cos, 0, 0]);
  }
  setLineDash(dash: readonly number[]): void {
    this.state = { ...this.state, dash };
  }
  setTransform(...matrix: State['matrix']): void {
    this.state = { ...this.state, matrix };
  }
  getTransform(): { readonly a: number } {
    return { a: this.state.matrix[0] };
  }
  /** Copies everything painted on another canvas. */
  drawImage(source: HTMLCanvasElement, left: number, top: number, width: number, height: number): void {
    const [x, y] = [width / source.width, height / source.height];
    for (const one of canvases.get(source)?.painted ?? []) {
      const from = this.onCanvas(left + one.left * x, top + one.top * y);
      const to = this.onCanvas(left + one.right * x, top + one.bottom * y);
      this.painted.push({ ...one, left: from.x, top: from.y, right: to.x, bottom: to.y });
    }
  }
  measureText(text: string): { readonly width: number } {
    return { width: text.length * 7 };
  }

  beginPath(): void {
    this.path = [];
  }
  moveTo(x: number, y: number): void {
    this.path.push(this.onCanvas(x, y));
  }
  lineTo(x: number, y: number): void {
    this.path.push(this.onCanvas(x, y));
  }
  quadraticCurveTo(_x: number, _y: number, x: number, y: number): void {
    this.lineTo(x, y);
  }
  rect(left: number, top: number, width: number, height: number): void {
    for (const x of [left, left + width]) for (const y of [top, top + height]) this.lineTo(x, y);
  }
  roundRect(left: number, top: number, width: number, height: number): void {
    this.rect(left, top, width, height);
  }
  arc(x: number, y: number, radius: number): void {
    this.ellipse(x, y, radius, radius);
  }
  ellipse(x: number, y: number, a: number, b: number): void {
    for (let step = 0; step < 16; step += 1) {
      const rad = (step * Math.PI) / 8;
      this.lineTo(x + a * Math.cos(rad), y + b * Math.sin(rad));
    }
  }

  fill(path?: NodePath): void {
    this.note('fill', this.pointsOf(path));
  }
  stroke(path?: NodePath): void {
    this.note('stroke', this.pointsOf(path));
  }
  fillRect(left: number, top: number, width: number, height: number): void {
    this.note('fill', this.corners(left, top, width, height));
  }
  strokeRect(left: number, top: number, width: number, height: number): void {
    this.note('stroke', this.corners(left, top, width, height));
  }
  fillText(text: string, x: number, y: number): void {
    this.note('text', [this.onCanvas(x, y)], text);
  }

  private pointsOf(path: NodePath | undefined): readonly Vec[] {
    return path === undefined ? this.path : path.points.map(({ x, y }) => this.onCanvas(x, y));
  }
  private corners(left: number, top: number, width: number, height: number): readonly Vec[] {
    return [this.onCanvas(left, top), this.onCanvas(left + width, top), this.onCanvas(left, top + height), this.onCanvas(left + width, top + height)]; // prettier-ignore
  }
  private onCanvas(x: number, y: number): Vec {
    const [a, b, c, d, e, f] = this.state.matrix;
    return { x: a * x + c * y + e, y: b * x + d * y + f };
  }
  private transform([a, b, c, d, e, f]: State['matrix']): void {
    const [A, B, C, D, E, F] = this.state.matrix;
    const matrix = [A * a + C * b, B * a + D * b, A * c + C * d, B * c + D * d, A * e + C * f + E, B * e + D * f + F] as const; // prettier-ignore
    this.state = { ...this.state, matrix };
  }
  private note(by: Painted['by'], points: readonly Vec[], text = ''): void {
    if (points.length === 0) return;
    const { fillStyle, strokeStyle, globalAlpha, lineWidth, dash, matrix } = this.state;
    const [xs, ys] = [points.map(({ x }) => x), points.map(({ y }) => y)];
    this.painted.push({
      by,
      color: by === 'stroke' ? strokeStyle : fillStyle,
      alpha: globalAlpha,
      left: Math.min(...xs),
      top: Math.min(...ys),
      right: Math.max(...xs),
      bottom: Math.max(...ys),
      line: lineWidth * Math.hypot(matrix[0], matrix[1]),
      dashed: dash.length > 0,
      text,
    });
  }
}

const canvases = new WeakMap<HTMLCanvasElement, RecordingCanvas>();

/** Gives the document paths and canvases, which Node lacks: the picture on one can be drawn on another. */
export function recordCanvases(): void {
  vi.stubGlobal('Path2D', NodePath);
  vi.spyOn(HTMLCanvasElement.prototype, 'getContext').mockImplementation(function (this: HTMLCanvasElement) {
    const canvas = canvases.get(this) ?? new RecordingCanvas();
    canvases.set(this, canvas);
    return canvas.context;
  });
}
