// A chart by uPlot in the colours of the theme. Its numbers are also said in words beside it, since
// a picture alone does not reach everybody.

import { useEffect, useRef } from 'preact/hooks';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { colour, fontOf, onTheme } from './theme';

export interface ChartSeries {
  words: string;
  colour: string;
  look: 'line' | 'dashed' | 'points' | 'bars';
}

interface ChartProps {
  title: string;
  xWords: string;
  series: readonly ChartSeries[];
  data: readonly (readonly (number | null)[])[];
  form: (value: unknown) => string;
  xForm?: (value: unknown) => string;
  fromZero?: boolean;
  /** Ranks and the like: no ticks between them. */
  isXWhole?: boolean;
}

const height = 220;
const wholeSteps = Array.from({ length: 24 }, (_, i) => [1, 2, 5][i % 3]! * 10 ** Math.floor(i / 3));

function seriesOf(series: ChartSeries, form: (value: unknown) => string): uPlot.Series {
  const ink = colour(series.colour);
  const common: uPlot.Series = {
    label: series.words,
    stroke: ink,
    width: 1.5,
    value: (_u, value) => form(value),
  };
  if (series.look === 'points') {
    return { ...common, paths: () => null, points: { show: true, size: 4, fill: ink, width: 0 } };
  }
  if (series.look === 'bars') {
    const paths = uPlot.paths.bars?.({ size: [0.8, 60] });
    return { ...common, fill: ink, points: { show: false }, ...(paths ? { paths } : {}) };
  }
  const dash = series.look === 'dashed' ? { dash: [5, 4] } : {};
  return { ...common, ...dash, points: { show: false } };
}

function optionsOf(props: ChartProps, width: number): uPlot.Options {
  const axis: uPlot.Axis = {
    stroke: colour('faint'),
    grid: { stroke: colour('line'), width: 1 },
    ticks: { stroke: colour('line'), width: 1 },
    font: fontOf(11),
  };
  const xForm = props.xForm ?? ((value) => String(value));
  return {
    width,
    height,
    scales: {
      x: { time: false },
      ...(props.fromZero ? { y: { range: (_u, _low, high) => [0, (high || 1) * 1.05] } } : {}),
    },
    axes: [
      { ...axis, label: props.xWords, labelSize: 18, labelFont: fontOf(11),
        values: (_u, values) => values.map(xForm), space: 70,
        ...(props.isXWhole ? { incrs: wholeSteps } : {}) },
      { ...axis, size: 70, values: (_u, values) => values.map(props.form) },
    ],
    series: [
      { label: props.xWords, value: (_u, value) => xForm(value) },
      ...props.series.map((series) => seriesOf(series, props.form)),
    ],
    legend: { live: true },
    cursor: { drag: { x: true, y: false } },
  };
}

export function Chart(props: ChartProps) {
  const place = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot>();
  const latest = useRef(props);
  latest.current = props;
  const shape = `${props.title} ${props.series.map((s) => s.words + s.look).join()} ${props.xWords}`;
  useEffect(() => {
    const element = place.current!;
    const make = () => {
      plot.current?.destroy();
      const width = Math.max(120, element.clientWidth);
      const data = latest.current.data as uPlot.AlignedData;
      plot.current = new uPlot(optionsOf(latest.current, width), data, element);
    };
    make();
    const sizes = new ResizeObserver(() => {
      const width = Math.max(120, element.clientWidth);
      if (plot.current && plot.current.width !== width) plot.current.setSize({ width, height });
    });
    sizes.observe(element);
    const forget = onTheme(make);
    return () => {
      sizes.disconnect();
      forget();
      plot.current?.destroy();
      plot.current = undefined;
    };
  }, [shape]);
  useEffect(() => plot.current?.setData(props.data as uPlot.AlignedData), [props.data]);
  return <div class="chart" ref={place} role="img" aria-label={props.title} />;
}
