# Configuration of Sphinx: sphinx-build doc/tutorials/content OUTPUT_DIRECTORY
project = "pcl_shape"
copyright = "2026, pcl_shape contributors"
source_suffix = ".rst"
master_doc = "index"
exclude_patterns = ["sources"]
pygments_style = "sphinx"
html_theme = "classic"
html_show_sourcelink = False
