import { describe, expect, it } from 'vitest';
import { categoryColour, cssColour, differentColours, stepsOf, unknownColour } from './surface_colours';

describe('categoryColour', () => {
  it('has 21 different colours, and then begins again', () => {
    const colours = Array.from({ length: differentColours }, (_, i) => cssColour(categoryColour(i)));
    expect(new Set(colours).size).toBe(21);
    expect(cssColour(categoryColour(differentColours))).toBe(colours[0]);
  });
});

describe('stepsOf', () => {
  it('divides what is known into equal steps from the least to the largest', () => {
    const { legend, colourOf } = stepsOf([0, 10, NaN, 70, 40]);
    expect(legend.map(({ from, to }) => [from, to])).toEqual([[10, 20], [20, 30], [30, 40], [40, 50], [50, 60], [60, 70]]);
    for (const { from, colour } of legend) expect(colourOf(from)).toEqual(colour);
    expect(colourOf(70)).toEqual(legend[5]!.colour);
    expect(colourOf(0)).toEqual(unknownColour);
    expect(colourOf(NaN)).toEqual(unknownColour);
  });

  it('has one step for one value, and none for none', () => {
    expect(stepsOf([5, 5]).legend).toHaveLength(1);
    expect(stepsOf([0]).legend).toHaveLength(0);
    expect(stepsOf([]).colourOf(3)).toEqual(unknownColour);
  });
});
