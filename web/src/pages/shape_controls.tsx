// What the page in space can be set to: colours, how far apart, a plane that cuts, what is marked.

import type { WorstPlace } from '../logic/quality';
import { figure } from '../logic/format';
import type { Axis } from '../logic/section';
import { axes } from '../logic/section';
import type { ShapeSettings } from '../logic/shape_settings';
import { mostApart } from '../logic/shape_settings';
import type { Way } from '../logic/surface_colours';
import { wayWords } from '../logic/surface_colours';
import { Choice } from '../ui/fields';

interface SliderProps {
  label: string;
  value: number;
  most: number;
  step: number;
  text: string;
  onChange: (value: number) => void;
}

function Slider({ label, value, most, step, text, onChange }: SliderProps) {
  return (
    <label class="field grows">
      <span>{label}</span>
      <input
        type="range"
        min={0}
        max={most}
        step={step}
        value={value}
        aria-valuetext={text}
        onInput={(event) => onChange(Number(event.currentTarget.value))}
      />
    </label>
  );
}

interface CheckProps {
  isOn: boolean;
  words: string;
  onChange: (isOn: boolean) => void;
}

function Check({ isOn, words, onChange }: CheckProps) {
  return (
    <label class="check">
      <input type="checkbox" checked={isOn} onChange={(event) => onChange(event.currentTarget.checked)} />
      <span>{words}</span>
    </label>
  );
}

interface ControlsProps {
  settings: ShapeSettings;
  change: (change: Partial<ShapeSettings>) => void;
  ways: readonly Way[];
  worst: WorstPlace | undefined;
  hasDefects: boolean;
  cutAt: number; // a coordinate
}

const sides = [
  { value: 'below', words: 'below it' },
  { value: 'above', words: 'above it' },
];

function CutControls({ settings, change, cutAt }: Pick<ControlsProps, 'settings' | 'change' | 'cutAt'>) {
  const { cut, at, keepsAbove } = settings;
  return (
    <>
      <Choice
        label="Cut across"
        value={cut ?? 'none'}
        options={[{ value: 'none', words: 'nothing' }, ...axes.map((axis) => ({ value: axis, words: axis }))]}
        onChange={(value) => change({ cut: value === 'none' ? undefined : (value as Axis) })}
      />
      {cut && (
        <>
          <Slider
            label={`Cut at ${cut} = ${figure(cutAt)}`}
            value={at}
            most={100}
            step={0.5}
            text={`${cut} = ${figure(cutAt)}`}
            onChange={(value) => change({ at: value })}
          />
          <Choice
            label="Keep"
            value={keepsAbove ? 'above' : 'below'}
            options={sides}
            onChange={(value) => change({ keepsAbove: value === 'above' })}
          />
        </>
      )}
    </>
  );
}

export function ShapeControls({ settings, change, ways, worst, hasDefects, cutAt }: ControlsProps) {
  const { way, apart, marks } = settings;
  return (
    <div class="row filters">
      <Choice
        label="Colour by"
        value={way}
        options={ways.map((value) => ({ value, words: wayWords[value] }))}
        onChange={(value) => change({ way: value as Way })}
      />
      <Slider label="Pulled apart" value={apart} most={mostApart} step={1} text={`${apart} %`} onChange={(value) => change({ apart: value })} />
      <CutControls settings={settings} change={change} cutAt={cutAt} />
      {worst && (
        <Check
          isOn={marks}
          words={`◆ the smallest angle, ${figure(worst.degrees)}°, at ${worst.at.map(figure).join(', ')}`}
          onChange={(isOn) => change({ marks: isOn })}
        />
      )}
      {hasDefects && <Check isOn={marks} words="defects" onChange={(isOn) => change({ marks: isOn })} />}
    </div>
  );
}
