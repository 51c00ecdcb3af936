// The text of `oblast help recipes` and docs/recipes.md.
#include "oblast/recipes.h"

namespace oblast::app {

const char* const recipes = R"(# Recipes

Commands for common tasks. Each reads and writes any of the formats (.gpkg .shp .geojson
.fgb .wkt). Add `--svg picture.svg` to see the answer, and `--overwrite` to run a command
again. `oblast help COMMAND` says more.

## Cut out a window (clip)

The forests inside one region, with their attributes:

    oblast clip forests.gpkg regions.gpkg --where-window "name = 'Picardie'" -o inside.gpkg

## Take an area away (erase)

The fields without the flooded area:

    oblast erase fields.gpkg flood.gpkg -o dry.gpkg --area m2

## Unite by a column (dissolve)

One row for each region, from its communes, with the sum of their inhabitants:

    oblast dissolve communes.gpkg --by region --agg people:sum -o united.gpkg

## Count how often a place is covered

On how many different days each place burnt, coloured by that number:

    oblast depth fires/ --by day -o days.gpkg --area m2 --svg days.svg

## Everything within a distance (buffer)

Everything within 500 m of a road, as one area:

    oblast buffer roads.geojson --distance 500m -o near.gpkg

Parcels without a strip of 10 m along their outlines, each with its attributes:

    oblast buffer parcels.gpkg --distance -10m --by-feature -o inner.gpkg

A zone of 20 m on the left side of each river, with flat ends:

    oblast buffer rivers.geojson --distance 20m --side left --cap flat --by-feature -o bank.gpkg

Longitudes and latitudes have no metres: compute in a projected system, and come back:

    oblast buffer stops.geojson --distance 0.5km --crs auto -o walk.geojson

## Which one is the nearest (zones)

The places to which each school is the nearest one, within the regions:

    oblast zones schools.geojson --within regions.gpkg --area m2 -o served.gpkg

The land around each parcel, at most 5 m from it, with a picture:

    oblast zones parcels.gpkg --distance 5m -o around.gpkg --svg around.svg

## Find overlaps in a layer that should have none

The places that two or more features cover:

    oblast union fields.gpkg --fill atleast:2 -o overlaps.gpkg

Which features they are: column `sources` of the rows whose `count` is 2 or more:

    oblast partition fields.gpkg -o parts.gpkg

## Find the faults of a layer, and repair them

All faults of the communes, with the overlaps and gaps between them, as points:

    oblast check communes.gpkg --coverage --faults faults.gpkg

Overlaps go to the larger field, and gaps of less than 5 m2 are closed. Rows and columns
stay as they are:

    oblast repair fields.gpkg --coverage --overlaps largest --gaps-below 5 -o clean.gpkg

## What changed between two dates

Each place with its old and its new use, in the columns `use_1` and `use_2`. They are null
where a layer has nothing:

    oblast overlay union landuse2010.gpkg landuse2020.gpkg -o both.gpkg

One row for each kind of change, with its area:

    oblast dissolve both.gpkg --where "use_1 <> use_2" --by use_1,use_2 --area m2 -o change.gpkg

If only the covered area matters, and not attributes: what is new, and what is gone:

    oblast overlay difference landuse2020.gpkg landuse2010.gpkg --merge -o new.gpkg
    oblast overlay difference landuse2010.gpkg landuse2020.gpkg --merge -o gone.gpkg

## Add the attributes of another layer (identity)

Each field, cut by the soils below it, with the columns of both. Fields stay whole where
there is no soil:

    oblast overlay identity fields.gpkg soils.gpkg -o soil_of_field.gpkg --area m2

## A table: how much of each use in each region

    oblast overlay intersection landuse2020.gpkg regions.gpkg -o pieces.gpkg
    oblast dissolve pieces.gpkg --by name,use --area m2 -o table.gpkg

## Prove that a result is the right answer

By independent code with exact arithmetic:

    oblast check new.gpkg --against landuse2020.gpkg landuse2010.gpkg --op difference
)";

}  // namespace oblast::app
