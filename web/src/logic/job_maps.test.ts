import { describe, expect, it } from 'vitest';
import type { ShownSurface } from './shown_surface';
import { colouringOfDefects, colouringOfLayers, noLayersColour } from './job_maps';

function surfaceOf(pieces: readonly number[], wholeTriangles = pieces.length): ShownSurface {
  return {
    vertices: new Float32Array(9), triangles: new Uint32Array(3 * pieces.length), pieces: Int32Array.from(pieces),
    kinds: [...new Set(pieces)], wholeTriangles, origin: [0, 0, 0],
  };
}

describe('colours of defects', () => {
  it('are the same for the same defect in all maps, whose numbers may differ', () => {
    const { ofPiece, legend } = colouringOfDefects(
      [surfaceOf([0, 0, 1]), surfaceOf([0])],
      [['open edge', 'self-intersection'], ['self-intersection']],
    );
    expect(ofPiece(0, 1)).toEqual(ofPiece(1, 0));
    expect(ofPiece(0, 0)).not.toEqual(ofPiece(0, 1));
    expect(legend.map(({ words, count }) => [words, count])).toEqual([['open edge', 2], ['self-intersection', 2]]);
  });

  it('are there for numbers without a meaning, and counts only where all triangles are', () => {
    const { legend } = colouringOfDefects([surfaceOf([7], 100)], [[]]);
    expect(legend).toHaveLength(1);
    expect(legend[0]!.words).toBe('defect');
    expect(legend[0]!.count).toBeUndefined();
  });
});

describe('colours of layers', () => {
  it('are by steps of whole numbers, and none stands out', () => {
    const { ofPiece, legend } = colouringOfLayers([surfaceOf([0, 1, 2, 20, 20, 19])]);
    expect(ofPiece(0, 0)).toEqual(noLayersColour);
    expect(ofPiece(0, 1)).toEqual(ofPiece(0, 2));
    expect(ofPiece(0, 20)).not.toEqual(ofPiece(0, 1));
    expect(legend.map(({ words, count }) => [words, count])).toEqual([
      ['no layers', 1], ['1 to 4 layers', 2], ['17 to 20 layers', 3],
    ]);
  });

  it('of few layers are one for each number', () => {
    expect(colouringOfLayers([surfaceOf([1, 2, 3])]).legend.map(({ words }) => words)).toEqual(['1 layer', '2 layers', '3 layers']);
    expect(colouringOfLayers([surfaceOf([0, 0])]).legend).toHaveLength(1);
    expect(colouringOfLayers([]).legend).toEqual([]);
  });
});
